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

uint32_t layers_of(const ScenePlace& place) { return static_cast<uint32_t>(place["layers"].integer); }

/// Rows in the file, columns in memory.
glm::dmat2 matrix(const SceneValue& rows) {
  Vec2 first = numbers(rows.items[0]), second = numbers(rows.items[1]);
  return {Vec2{first.x, second.x}, Vec2{first.y, second.y}};
}

std::string describe(Vec2 point) { return fmt::format("({}, {})", point.x, point.y); }

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

InputError ScenePlace::refusal(std::string_view name, std::initializer_list<const SceneValue*> parts,
                               const std::string& found, const std::string& expected) const {
  return sluice::refusal(blame(parts), fmt::format("{}.{}", path, name), found, expected);
}

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

Vec2 ShapeReader::point(const ScenePlace& place, std::string_view name) const {
  return point(place[name], fmt::format("{}.{}", place.path, name));
}

std::pair<Vec2, Vec2> ShapeReader::box(const ScenePlace& place, bool finite) const {
  const Vec2 min = point(place, "min"), max = point(place, "max"), size = max - min;
  if (!(size.x > 0 && size.y > 0) || (finite && !(std::isfinite(size.x) && std::isfinite(size.y))))
    throw place.refusal(
        "max", {&place["max"], &place["min"], &spacing_}, describe(max),
        fmt::format("more than min {} both ways{}", describe(min), finite ? ", by a finite length" : ""));
  return {min, max};
}

void ShapeReader::add_samples(const ScenePlace& place, double count) {
  samples_ += count;
  if (!(samples_ <= max_samples))
    throw refusal(blame({&spacing_, place.table}), "particles.spacing",
                  fmt::format("{}, which makes {:.4g} samples up to {}", h_, samples_, place.path),
                  fmt::format("at most {:.0f} in all shapes together; use a larger spacing or smaller shapes",
                              max_samples));
}

Rect ShapeReader::rect(const ScenePlace& place) {
  const SceneValue *max = place.table->find("max"), *count = place.table->find("count");
  if (max && count)
    throw place.refusal("count", {count, max}, describe(*count) + " together with max", "one of the two");
  if (!max && !count)
    throw place.refusal("max", {place.table}, "nothing", "an array of two lengths, or count in its place");
  Rect rect{point(place, "min"), {}, 0};
  Vec2 n = count ? numbers(*count) : glm::ceil((point(place, "max") - rect.min) / h_ - 1e-6);
  if (!(n.x >= 1 && n.y >= 1))  // only without a count
    throw place.refusal("max", {max, &place["min"], &spacing_}, describe(point(place, "max")),
                        fmt::format("more than min {} both ways", describe(rect.min)));
  add_samples(place, n.x * n.y);
  rect.count = {static_cast<uint32_t>(n.x), static_cast<uint32_t>(n.y)};
  if (place.table->find("layers")) rect.layers = layers_of(place);
  return rect;
}

Disc ShapeReader::disc(const ScenePlace& place) {
  const SceneValue& radius = place["radius"];
  Disc disc{point(place, "centre"), length(radius, place.path + ".radius")};
  if (!(disc.radius > 0))
    throw place.refusal(
        "radius", {&radius, &spacing_},
        describe(radius) + (radius.is_number() ? "" : fmt::format(", which is {}", disc.radius)),
        "a length greater than 0");
  double across = 2 * disc.radius / h_ + 1;
  add_samples(place, across * across);
  return disc;
}

Polygon ShapeReader::polygon(const ScenePlace& place, bool needs_centre) {
  const SceneValue& points = place["points"];
  Polygon polygon;
  for (size_t i = 0; i < points.items.size(); ++i)
    polygon.points.push_back(point(points.items[i], fmt::format("{}.points.{}", place.path, i)));
  if (on_a_line(polygon.points))
    throw place.refusal("points", {&points, &spacing_}, "points on one line", "corners that enclose an area");
  Vec2 low = polygon.points[0], high = low;
  for (Vec2 p : polygon.points) low = glm::min(low, p), high = glm::max(high, p);
  Vec2 n = (high - low) / h_ + 1.0;
  add_samples(place, n.x * n.y);
  const Vec2 centre = needs_centre ? centre_of(polygon, h_) : low;
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
    throw place.refusal("points", {&points, &spacing_},
                        "corners with edges that cross, around nothing on balance",
                        "corners in order around an area");
  return polygon;
}

Container ShapeReader::container(const ScenePlace& place) {
  auto [min, max] = box(place);
  Container box{min, max, layers_of(place)};
  for (const SceneValue& side : place["sides"].items) {
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

Segment ShapeReader::segment(const ScenePlace& place) {
  Segment wall{point(place, "from"), point(place, "to"), layers_of(place)};
  if (wall.from == wall.to)
    throw place.refusal("to", {&place["to"], &place["from"], &spacing_}, describe(wall.to),
                        "another point than from");
  add_samples(place, wall.layers * (glm::distance(wall.from, wall.to) / h_ + 1));
  return wall;
}

template <class Shape>
std::vector<Shape> ShapeReader::shapes(const SceneValue& table, const std::string& path) {
  std::vector<ScenePlace> places;
  for (const SceneValue::Member& member : table.members)
    for (size_t i = 0; i < member.value.items.size(); ++i)
      if (const SceneValue& item = member.value.items[i]; item.kind == SceneValue::Kind::table)
        places.push_back({&item, fmt::format("{}.{}.{}", path, member.name, i), member.name});
  std::ranges::stable_sort(places, {}, [](const ScenePlace& place) { return place.table->order; });

  constexpr bool fluid = std::is_same_v<Shape, FluidShape>;
  std::vector<Shape> shapes;
  for (const ScenePlace& place : places) {
    Shape& shape = shapes.emplace_back();
    shape.key = place.path;
    shape.where = place.table->where;
    if (place.kind == "rect") shape.geometry = rect(place);
    if (place.kind == "disc") shape.geometry = disc(place);
    if (place.kind == "polygon") shape.geometry = polygon(place, fluid);
    if constexpr (fluid) {
      shape.velocity = numbers(place["velocity"]);
      shape.velocity_gradient = matrix(place["velocity_gradient"]);
    } else {
      if (place.kind == "container") shape.geometry = container(place);
      if (place.kind == "segment") shape.geometry = segment(place);
    }
  }
  return shapes;
}

std::vector<FluidShape> ShapeReader::fluid(const SceneValue& table) {
  return shapes<FluidShape>(table, "fluid");
}

std::vector<BoundaryShape> ShapeReader::boundary(const SceneValue& table) {
  return shapes<BoundaryShape>(table, "boundary");
}

}  // namespace sluice
