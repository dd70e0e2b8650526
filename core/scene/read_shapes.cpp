// Reading of shapes: lengths in numbers, counts, and the checks that need both.
#include "core/scene/read_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/scene/length.hpp"
#include "core/scene/shapes.hpp"

namespace sluice {
namespace {

constexpr double max_samples = 4294967295.0;  // ids are 32 bits wide

uint32_t layers_of(const SceneValue& table) { return static_cast<uint32_t>(table.at("layers").integer); }

/// Rows in the file, columns in memory.
glm::dmat2 matrix(const SceneValue& rows) {
  Vec2 first = numbers(rows.items[0]), second = numbers(rows.items[1]);
  return {Vec2{first.x, second.x}, Vec2{first.y, second.y}};
}

bool on_a_line(const std::vector<Vec2>& points) {
  auto far = std::ranges::max_element(points, {}, [&](Vec2 p) { return glm::distance(p, points[0]); });
  Vec2 along = *far - points[0];
  double reach = glm::length(along);
  return std::ranges::all_of(points, [&](Vec2 p) {
    Vec2 d = p - points[0];
    return std::abs(along.x * d.y - along.y * d.x) <= 1e-9 * reach * reach;
  });
}

}  // namespace

const std::string& blame(std::initializer_list<const SceneValue*> values) {
  for (const SceneValue* value : values)
    if (value && value->overridden) return value->where;
  for (const SceneValue* value : values)
    if (value && !value->defaulted) return value->where;
  return (*values.begin())->where;
}

Vec2 numbers(const SceneValue& pair) { return {pair.items[0].number, pair.items[1].number}; }

std::string describe(Vec2 point) { return fmt::format("({}, {})", point.x, point.y); }

double ShapeReader::length(const SceneValue& value, const std::string& path) const {
  double result = value.is_number() ? value.number : parse_length(value.text)->value(h_);
  if (!std::isfinite(result))
    throw refusal(blame({&value, &spacing_}), path,
                  fmt::format("{}, which is {} with h = {}", describe(value), result, h_), "a finite length");
  return result;
}

Vec2 ShapeReader::point(const SceneValue& value, const std::string& path) const {
  return {length(value.items[0], path + ".0"), length(value.items[1], path + ".1")};
}

std::vector<ShapeReader::Place> ShapeReader::places(const SceneValue& table, const std::string& path) {
  std::vector<Place> all;
  for (const SceneValue::Member& member : table.members) {
    if (member.value.kind != SceneValue::Kind::array) continue;
    if (member.value.items.empty() || member.value.items[0].kind != SceneValue::Kind::table) continue;
    for (size_t i = 0; i < member.value.items.size(); ++i)
      all.push_back({&member.value.items[i], member.name, fmt::format("{}.{}.{}", path, member.name, i)});
  }
  std::ranges::stable_sort(all, {}, [](const Place& place) { return place.table->order; });
  return all;
}

void ShapeReader::add_samples(const Place& place, double count) {
  samples_ += count;
  if (!(samples_ <= max_samples))
    throw refusal(blame({&spacing_, place.table}), "particles.spacing",
                  fmt::format("{}, which makes {:.4g} samples up to {}", h_, samples_, place.path),
                  fmt::format("at most {:.0f} in all shapes together; use a larger spacing or smaller shapes",
                              max_samples));
}

Rect ShapeReader::rect(const Place& place) {
  const SceneValue& table = *place.table;
  const SceneValue* max = table.find("max");
  const SceneValue* count = table.find("count");
  if (max && count)
    throw refusal(blame({count, max}), place.path + ".count", describe(*count) + " together with max",
                  "one of the two");
  if (!max && !count)
    throw refusal(table.where, place.path + ".max", "nothing",
                  "an array of two lengths, or count in its place");
  Rect rect{point(table.at("min"), place.path + ".min"), {}, 0};
  Vec2 n = count ? numbers(*count) : Vec2{};
  if (max) {
    Vec2 corner = point(*max, place.path + ".max");
    n = glm::ceil((corner - rect.min) / h_ - 1e-6);
    if (!(n.x >= 1 && n.y >= 1))
      throw refusal(blame({max, &table.at("min"), &spacing_}), place.path + ".max", describe(corner),
                    fmt::format("more than min {} both ways", describe(rect.min)));
  }
  add_samples(place, n.x * n.y);
  rect.count = {static_cast<uint32_t>(n.x), static_cast<uint32_t>(n.y)};
  if (table.find("layers")) rect.layers = layers_of(table);
  return rect;
}

Disc ShapeReader::disc(const Place& place) {
  const SceneValue& radius = place.table->at("radius");
  Disc disc{point(place.table->at("centre"), place.path + ".centre"), length(radius, place.path + ".radius")};
  if (!(disc.radius > 0))
    throw refusal(blame({&radius, &spacing_}), place.path + ".radius",
                  describe(radius) + (radius.is_number() ? "" : fmt::format(", which is {}", disc.radius)),
                  "a length greater than 0");
  double across = 2 * disc.radius / h_ + 1;
  add_samples(place, across * across);
  return disc;
}

Polygon ShapeReader::polygon(const Place& place) {
  const SceneValue& points = place.table->at("points");
  Polygon polygon;
  for (size_t i = 0; i < points.items.size(); ++i)
    polygon.points.push_back(point(points.items[i], fmt::format("{}.points.{}", place.path, i)));
  if (on_a_line(polygon.points))
    throw refusal(blame({&points, &spacing_}), place.path + ".points", "points on one line",
                  "corners that enclose an area");
  Vec2 low = polygon.points[0], high = low;
  for (Vec2 p : polygon.points) low = glm::min(low, p), high = glm::max(high, p);
  Vec2 n = (high - low) / h_ + 1.0;
  add_samples(place, n.x * n.y);
  return polygon;
}

Polygon ShapeReader::fluid_polygon(const Place& place) {
  Polygon made = polygon(place);
  const Vec2 centre = centre_of(made, h_);
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
    throw refusal(blame({&place.table->at("points"), &spacing_}), place.path + ".points",
                  "corners with edges that cross, around nothing on balance",
                  "corners in order around an area");
  return made;
}

Container ShapeReader::container(const Place& place) {
  const SceneValue& table = *place.table;
  Container box{point(table.at("min"), place.path + ".min"), point(table.at("max"), place.path + ".max"),
                layers_of(table)};
  if (!(box.max.x > box.min.x && box.max.y > box.min.y))
    throw refusal(blame({&table.at("max"), &table.at("min"), &spacing_}), place.path + ".max",
                  describe(box.max), fmt::format("more than min {} both ways", describe(box.min)));
  for (const SceneValue& side : table.at("sides").items) {
    switch (value_named<Side>(side.text).value()) {
      case Side::left: box.left = true; break;
      case Side::right: box.right = true; break;
      case Side::bottom: box.bottom = true; break;
      case Side::top: box.top = true; break;
    }
  }
  Vec2 n = (box.max - box.min) / h_ + 1.0;
  add_samples(place, box.layers * (n.y * (box.left + box.right) + n.x * (box.bottom + box.top)));
  return box;
}

Segment ShapeReader::segment(const Place& place) {
  const SceneValue& table = *place.table;
  Segment wall{point(table.at("from"), place.path + ".from"), point(table.at("to"), place.path + ".to"),
               layers_of(table)};
  if (wall.from == wall.to)
    throw refusal(blame({&table.at("to"), &table.at("from"), &spacing_}), place.path + ".to",
                  describe(wall.to), "another point than from");
  add_samples(place, wall.layers * (glm::distance(wall.from, wall.to) / h_ + 1));
  return wall;
}

std::vector<FluidShape> ShapeReader::fluid(const SceneValue& table) {
  std::vector<FluidShape> shapes;
  for (const Place& place : places(table, "fluid")) {
    FluidShape& shape = shapes.emplace_back();
    if (place.kind == "rect") shape.geometry = rect(place);
    if (place.kind == "disc") shape.geometry = disc(place);
    if (place.kind == "polygon") shape.geometry = fluid_polygon(place);
    shape.velocity = numbers(place.table->at("velocity"));
    shape.velocity_gradient = matrix(place.table->at("velocity_gradient"));
    shape.key = place.path;
    shape.where = place.table->where;
  }
  return shapes;
}

std::vector<BoundaryShape> ShapeReader::boundary(const SceneValue& table) {
  std::vector<BoundaryShape> shapes;
  for (const Place& place : places(table, "boundary")) {
    BoundaryShape& shape = shapes.emplace_back();
    if (place.kind == "rect") shape.geometry = rect(place);
    if (place.kind == "disc") shape.geometry = disc(place);
    if (place.kind == "polygon") shape.geometry = polygon(place);
    if (place.kind == "container") shape.geometry = container(place);
    if (place.kind == "segment") shape.geometry = segment(place);
    shape.key = place.path;
    shape.where = place.table->where;
  }
  return shapes;
}

}  // namespace sluice
