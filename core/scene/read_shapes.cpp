// Lengths in numbers, shapes with their counts, and the checks that need both.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/scene/length.hpp"
#include "core/scene/passes.hpp"
#include "core/scene/points_file.hpp"
#include "core/scene/shapes.hpp"

namespace sluice {
namespace {

constexpr double max_samples = 4294967295.0;  // ids are 32 bits wide

uint32_t layers_of(const SceneValue& table) { return static_cast<uint32_t>(table.at("layers").integer); }

/// Rows in the file, columns in memory.
glm::dmat2 matrix(const SceneValue& rows) {
  Vec2 first = vector_of(rows.items[0]), second = vector_of(rows.items[1]);
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

/// A name that can be part of a column's.
std::string plain_name(const SceneValue& value) {
  const bool plain = !value.text.empty() && std::ranges::all_of(value.text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c >= 0x80;
  });
  if (!plain) throw refusal({&value}, describe(value), "a name of letters, digits, _ and -");
  return value.text;
}

/// Refuses the second of two names that are the same.
void refuse_same_names(const std::vector<const SceneValue*>& names) {
  for (size_t i = 0; i < names.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      if (names[i]->text == names[k]->text)
        throw refusal({names[i], names[k]}, describe(*names[i]) + " a second time", "a name of its own");
}

/// Reads lengths and shapes.
class ShapeReader {
 public:
  /// `spacing` is the value of particles.spacing; it must outlive the reader.
  /// Files are looked for from the `folder` on.
  ShapeReader(const SceneValue& spacing, std::filesystem::path folder)
      : spacing_(spacing), h_(spacing.number), folder_(std::move(folder)) {}

  Vec2 point(const SceneValue& pair) const { return {length(pair.items[0]), length(pair.items[1])}; }

  /// The points `min` and `max` of a table, of which `max` has to be beyond it both ways, and when asked not
  /// infinitely far.
  std::pair<Vec2, Vec2> box(const SceneValue& table, bool finite) const {
    const Vec2 min = point(table.at("min")), max = point(table.at("max")), size = max - min;
    if (!(size.x > 0 && size.y > 0) || (finite && !(std::isfinite(size.x) && std::isfinite(size.y))))
      throw refusal(
          {&table.at("max"), &table.at("min"), &spacing_}, describe(max),
          fmt::format("more than min {} both ways{}", describe(min), finite ? ", by a finite length" : ""));
    return {min, max};
  }

  /// All shapes of a [fluid] or a [boundary] table in the order of the file.
  template <class Shape>
  std::vector<Shape> shapes(const SceneValue& parent) {
    std::vector<std::pair<std::string_view, const SceneValue*>> tables;  // with their kinds
    for (const SceneValue::Member& member : parent.members)
      for (const SceneValue& item : member.value.items)
        if (item.kind == SceneValue::Kind::table) tables.emplace_back(member.name, &item);
    std::ranges::stable_sort(tables, {}, [](const auto& table) { return table.second->order; });

    constexpr bool fluid = std::is_same_v<Shape, FluidShape>;
    std::vector<Shape> shapes;
    std::vector<const SceneValue*> names;
    for (auto [kind, table] : tables) {
      Shape& shape = shapes.emplace_back();
      shape.key = table->path;
      shape.where = table->where;
      if (kind == "rect") shape.geometry = rect(*table);
      if (kind == "disc") shape.geometry = disc(*table);
      if (kind == "polygon") shape.geometry = polygon(*table, fluid);
      if constexpr (fluid) {
        shape.velocity = vector_of(table->at("velocity"));
        if (kind == "particles")
          shape.geometry = particles(*table);
        else
          shape.velocity_gradient = matrix(table->at("velocity_gradient"));
      } else {
        if (const SceneValue* name = table->find("name")) {
          shape.name = plain_name(*name);
          names.push_back(name);
        }
        if (kind == "container") shape.geometry = container(*table);
        if (kind == "segment") shape.geometry = segment(*table);
      }
    }
    refuse_same_names(names);
    return shapes;
  }

  Probe probe(const SceneValue& table) const {
    const SceneValue *at = table.find("at"), *x = table.find("x"), *y = table.find("y");
    if ((at != nullptr) + (x != nullptr) + (y != nullptr) != 1)
      throw refusal(table.where, table.path,
                    at || x || y ? "more than one of at, x and y" : "nothing of at, x and y", "one of them");
    Probe probe{plain_name(table.at("name")), {}, {}, {}};
    if (at) probe.at = point(*at);
    if (x) probe.x = length(*x);
    if (y) probe.y = length(*y);
    return probe;
  }

 private:
  double length(const SceneValue& value) const {
    double result = value.is_number() ? value.number : parse_length(value.text)->value(h_);
    if (!std::isfinite(result))
      throw refusal({&value, &spacing_},
                    fmt::format("{}, which is {} with h = {}", describe(value), result, h_),
                    "a finite length");
    return result;
  }

  Rect rect(const SceneValue& table) {
    const SceneValue *max = table.find("max"), *count = table.find("count");
    if (max && count) throw refusal({count, max}, describe(*count) + " together with max", "one of the two");
    if (!max && !count)
      throw refusal(table.where, table.path + ".max", "nothing",
                    "an array of two lengths, or count in its place");
    Rect rect{point(table.at("min")), {}, 0};
    Vec2 n = count ? vector_of(*count) : glm::ceil((point(table.at("max")) - rect.min) / h_ - 1e-6);
    if (!(n.x >= 1 && n.y >= 1))  // only without a count
      throw refusal({max, &table.at("min"), &spacing_}, describe(point(table.at("max"))),
                    fmt::format("more than min {} both ways", describe(rect.min)));
    add_samples(table, n.x * n.y);
    rect.count = {static_cast<uint32_t>(n.x), static_cast<uint32_t>(n.y)};
    if (table.find("layers")) rect.layers = layers_of(table);
    return rect;
  }

  Disc disc(const SceneValue& table) {
    const SceneValue& radius = table.at("radius");
    Disc disc{point(table.at("centre")), length(radius)};
    if (!(disc.radius > 0))
      throw refusal({&radius, &spacing_},
                    describe(radius) + (radius.is_number() ? "" : fmt::format(", which is {}", disc.radius)),
                    "a length greater than 0");
    double across = 2 * disc.radius / h_ + 1;
    add_samples(table, across * across);
    return disc;
  }

  Polygon polygon(const SceneValue& table, bool needs_centre) {
    const SceneValue& points = table.at("points");
    Polygon polygon;
    for (const SceneValue& item : points.items) polygon.points.push_back(point(item));
    if (on_a_line(polygon.points))
      throw refusal({&points, &spacing_}, "points on one line", "corners that enclose an area");
    Vec2 low = polygon.points[0], high = low;
    for (Vec2 p : polygon.points) low = glm::min(low, p), high = glm::max(high, p);
    Vec2 n = (high - low) / h_ + 1.0;
    add_samples(table, n.x * n.y);
    const Vec2 centre = needs_centre ? centre_of(polygon, h_) : low;
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
      throw refusal({&points, &spacing_}, "corners with edges that cross, around nothing on balance",
                    "corners in order around an area");
    return polygon;
  }

  Points particles(const SceneValue& table) {
    const SceneValue& file = table.at("file");
    Points points;
    try {
      points = read_points(folder_ / file.text);
    } catch (const InputError& error) {
      throw refusal({&file}, error.what(), "a CSV file with columns x and y");
    }
    add_samples(table, static_cast<double>(points.at.size()));
    return points;
  }

  Container container(const SceneValue& table) {
    auto [min, max] = box(table, false);
    Container box{min, max, layers_of(table)};
    for (const SceneValue& side : table.at("sides").items) {
      switch (value_named<Side>(side.text).value()) {
        case Side::left: box.left = true; break;
        case Side::right: box.right = true; break;
        case Side::bottom: box.bottom = true; break;
        case Side::top: box.top = true; break;
      }
    }
    Vec2 n = (box.max - box.min) / h_ + 1.0;
    add_samples(table, box.layers * (n.y * (box.left + box.right) + n.x * (box.bottom + box.top)));
    return box;
  }

  Segment segment(const SceneValue& table) {
    Segment wall{point(table.at("from")), point(table.at("to")), layers_of(table)};
    if (wall.from == wall.to)
      throw refusal({&table.at("to"), &table.at("from"), &spacing_}, describe(wall.to),
                    "another point than from");
    add_samples(table, wall.layers * (glm::distance(wall.from, wall.to) / h_ + 1));
    return wall;
  }

  /// Keeps the samples of all shapes within what can be numbered.
  void add_samples(const SceneValue& table, double count) {
    samples_ += count;
    if (!(samples_ <= max_samples))
      throw refusal(
          {&spacing_, &table},
          fmt::format("{}, which makes {:.4g} samples up to {}", h_, samples_, table.path),
          fmt::format("at most {:.0f} in all shapes together; use a larger spacing or smaller shapes",
                      max_samples));
  }

  const SceneValue& spacing_;
  double h_;
  std::filesystem::path folder_;
  double samples_ = 0;  ///< so far; an upper bound for discs and polygons
};

[[noreturn]] void refuse_no_fluid(const SceneValue& table) {
  const std::string* where = &table.where;
  for (const SceneValue::Member& shapes : table.members)  // emptied by --set fluid.rect=[]
    if (shapes.value.overridden && shapes.value.kind == SceneValue::Kind::array && shapes.value.items.empty())
      where = &shapes.value.where;
  throw refusal(*where, "fluid", "no fluid", "at least one shape, such as [[fluid.rect]]");
}

}  // namespace

Vec2 vector_of(const SceneValue& pair) { return {pair.items[0].number, pair.items[1].number}; }

void read_lengths(const SceneValue& root, Scene& scene) {
  ShapeReader reader(root.at("particles").at("spacing"), std::filesystem::path(scene.file).parent_path());
  std::tie(scene.domain_min, scene.domain_max) = reader.box(root.at("domain"), true);
  const SceneValue& fluid = root.at("fluid");
  scene.centre = reader.point(fluid.at("centre"));
  scene.fluid = reader.shapes<FluidShape>(fluid);
  if (scene.fluid.empty()) refuse_no_fluid(fluid);
  if (const SceneValue* boundary = root.find("boundary"))
    scene.boundary = reader.shapes<BoundaryShape>(*boundary);
  if (const SceneValue* probes = root.find("probe")) {
    std::vector<const SceneValue*> names;
    for (const SceneValue& table : probes->items) {
      scene.probes.push_back(reader.probe(table));
      names.push_back(&table.at("name"));
    }
    refuse_same_names(names);
  }
}

}  // namespace sluice
