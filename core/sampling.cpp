// Lattices, walls, the overlap check and the jitter of the start.
#include "core/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "core/error.hpp"

namespace sluice {
namespace {

struct Box {
  Vec2 min, max;
};

std::vector<Vec2> points_of(const Rect& rect, double h) {
  std::vector<Vec2> points;
  const auto [nx, ny] = std::pair(rect.count.x, rect.count.y);
  const auto inner = [&](uint32_t i, uint32_t n) { return i >= rect.layers && i + rect.layers < n; };
  for (uint32_t j = 0; j < ny; ++j) {
    for (uint32_t i = 0; i < nx; ++i) {
      if (rect.layers > 0 && inner(i, nx) && inner(j, ny)) continue;
      points.push_back(rect.min + h * Vec2(i, j));
    }
  }
  return points;
}

/// All points of the lattice through `origin` in `box` for which `inside` holds.
template <class Inside>
std::vector<Vec2> lattice(Vec2 origin, Box box, double h, Inside inside) {
  std::vector<Vec2> points;
  const glm::i64vec2 first(glm::ceil((box.min - origin) / h)), last(glm::floor((box.max - origin) / h));
  for (int64_t j = first.y; j <= last.y; ++j) {
    for (int64_t i = first.x; i <= last.x; ++i) {
      const Vec2 point = origin + h * Vec2(i, j);
      if (inside(point)) points.push_back(point);
    }
  }
  return points;
}

std::vector<Vec2> points_of(const Disc& disc, double h) {
  const double limit = disc.radius * (1 - 1e-9);
  return lattice(disc.centre, {disc.centre - disc.radius, disc.centre + disc.radius}, h,
                 [&](Vec2 point) { return glm::length(point - disc.centre) < limit; });
}

Box bounding_box(const std::vector<Vec2>& points) {
  Box box{points.front(), points.front()};
  for (const Vec2 point : points) box = {glm::min(box.min, point), glm::max(box.max, point)};
  return box;
}

/// Strictly inside: an odd number of edges lies to the right of the point, and none passes through it.
bool inside_polygon(const std::vector<Vec2>& corners, Vec2 point, double slack) {
  bool inside = false;
  for (size_t i = 0, last = corners.size() - 1; i < corners.size(); last = i++) {
    const Vec2 a = corners[last], edge = corners[i] - a, offset = point - a;
    const double t = std::clamp(glm::dot(offset, edge) / glm::dot(edge, edge), 0.0, 1.0);
    if (glm::length(offset - t * edge) <= slack) return false;
    const bool crosses = (a.y > point.y) != (corners[i].y > point.y);
    if (crosses && offset.x < edge.x * offset.y / edge.y) inside = !inside;
  }
  return inside;
}

std::vector<Vec2> points_of(const Polygon& polygon, double h) {
  return lattice(polygon.points.front(), bounding_box(polygon.points), h,
                 [&](Vec2 point) { return inside_polygon(polygon.points, point, 1e-9 * h); });
}

std::vector<Vec2> points_of(const Container& box, double h) {
  std::vector<Vec2> points;
  const auto column = [&](double x) {
    for (uint32_t j = 0; box.min.y + j * h <= box.max.y + 1e-6 * h; ++j)
      points.push_back({x, box.min.y + j * h});
  };
  const auto row = [&](double y) {
    const double end = box.max.x - (box.layers - 0.5) * h;
    for (uint32_t i = box.layers; box.min.x + i * h < end; ++i) points.push_back({box.min.x + i * h, y});
  };
  for (uint32_t layer = 0; box.left && layer < box.layers; ++layer) column(box.min.x + layer * h);
  for (uint32_t layer = 0; box.right && layer < box.layers; ++layer) column(box.max.x - layer * h);
  for (uint32_t layer = 0; box.bottom && layer < box.layers; ++layer) row(box.min.y + layer * h);
  for (uint32_t layer = 0; box.top && layer < box.layers; ++layer) row(box.max.y - layer * h);
  return points;
}

std::vector<Vec2> points_of(const Segment& segment, double h) {
  std::vector<Vec2> points;
  const double length = glm::length(segment.to - segment.from);
  const Vec2 along = (segment.to - segment.from) / length, right(along.y, -along.x);
  for (uint32_t layer = 0; layer < segment.layers; ++layer) {
    for (uint32_t i = 0; i * h <= length + 1e-6 * h; ++i) {
      points.push_back(segment.from + i * h * along + layer * h * right);
    }
  }
  return points;
}

template <class Geometry>
std::vector<Vec2> points_of_any(const Geometry& geometry, double h) {
  return std::visit([&](const auto& shape) { return points_of(shape, h); }, geometry);
}

/// Finds points within h/2 of a point, among those added so far.
class Places {
 public:
  explicit Places(double h) : edge_(h / 2), reach_(h / 2 * (1 - 1e-6)) {}

  void add(Vec2 point, uint32_t tag) {
    const uint32_t here = static_cast<uint32_t>(entries_.size());
    const auto [cell, fresh] = heads_.try_emplace(key(cell_of(point)), here);
    entries_.push_back({point, tag, fresh ? none : cell->second});
    cell->second = here;
  }

  struct Entry {
    Vec2 point;
    uint32_t tag, next;
  };

  /// An entry within h/2 of `point`, or nullptr.
  const Entry* near(Vec2 point) const {
    if (entries_.empty()) return nullptr;
    const glm::i64vec2 centre = cell_of(point);
    for (int64_t j = centre.y - 1; j <= centre.y + 1; ++j) {
      for (int64_t i = centre.x - 1; i <= centre.x + 1; ++i) {
        const auto cell = heads_.find(key({i, j}));
        for (uint32_t e = cell == heads_.end() ? none : cell->second; e != none; e = entries_[e].next) {
          if (glm::length(entries_[e].point - point) < reach_) return &entries_[e];
        }
      }
    }
    return nullptr;
  }

 private:
  static constexpr uint32_t none = ~0u;
  glm::i64vec2 cell_of(Vec2 point) const { return glm::i64vec2(glm::floor(point / edge_)); }
  static uint64_t key(glm::i64vec2 cell) {
    return static_cast<uint64_t>(cell.x) * 0x9e3779b97f4a7c15u ^ static_cast<uint64_t>(cell.y);
  }

  double edge_, reach_;
  std::unordered_map<uint64_t, uint32_t> heads_;
  std::vector<Entry> entries_;
};

void sample_boundary(const Scene& scene, Samples& samples, Places& places) {
  for (uint32_t s = 0; s < scene.boundary.size(); ++s) {
    for (const Vec2 point : points_of_any(scene.boundary[s].geometry, scene.spacing)) {
      if (places.near(point) != nullptr) {
        ++samples.boundary_dropped;
        continue;
      }
      places.add(point, s);
      samples.boundary.push_back(point);
    }
  }
}

void refuse_overlap(const Scene& scene, const FluidShape& shape, Vec2 point, const Places::Entry& other) {
  const size_t walls = scene.boundary.size();
  const std::string& key =
      other.tag < walls ? scene.boundary[other.tag].key : scene.fluid[other.tag - walls].key;
  throw InputError(fmt::format(
      "{}: {}: found fluid at ({:g}, {:g}) within half a spacing of {} at ({:g}, {:g}), expected at least "
      "h/2 = {:g} "
      "between them",
      shape.where, shape.key, point.x, point.y, key, other.point.x, other.point.y, scene.spacing / 2));
}

void sample_fluid(const Scene& scene, Samples& samples, Places& places) {
  for (uint32_t s = 0; s < scene.fluid.size(); ++s) {
    const FluidShape& shape = scene.fluid[s];
    const std::vector<Vec2> points = points_of_any(shape.geometry, scene.spacing);
    if (points.empty()) {
      throw InputError(
          fmt::format("{}: {}: found no particle in it, expected a shape that holds at least one; make it "
                      "larger or particles.spacing smaller",
                      shape.where, shape.key));
    }
    for (const Vec2 point : points) {
      if (const auto* other = places.near(point)) refuse_overlap(scene, shape, point, *other);
      samples.fluid.push_back(point);
      samples.fluid_shape.push_back(s);
    }
    // Only later shapes can come too close: within a shape particles are a spacing apart.
    if (s + 1 == scene.fluid.size()) continue;
    for (const Vec2 point : points) places.add(point, static_cast<uint32_t>(scene.boundary.size()) + s);
  }
}

double area_bound(const Rect& rect, double) { return double(rect.count.x) * double(rect.count.y); }
double area_bound(const Disc& disc, double h) { return std::numbers::pi * std::pow(disc.radius / h + 1, 2); }
double area_bound(const Polygon& polygon, double h) {
  const Box box = bounding_box(polygon.points);
  const Vec2 n = (box.max - box.min) / h + 1.0;
  return n.x * n.y;
}
double area_bound(const Container& box, double h) {
  const Vec2 n = (box.max - box.min) / h + 1.0;
  return box.layers * ((box.left + box.right) * n.y + (box.bottom + box.top) * n.x);
}
double area_bound(const Segment& segment, double h) {
  return segment.layers * (glm::length(segment.to - segment.from) / h + 1);
}

Vec2 centre_of(const Rect& rect, double h) { return rect.min + 0.5 * h * (Vec2(rect.count) - 1.0); }
Vec2 centre_of(const Disc& disc, double) { return disc.centre; }
Vec2 centre_of(const Polygon& polygon, double) {
  double area = 0;
  Vec2 moment{};
  const Vec2 origin = polygon.points.front();
  for (size_t i = 0; i < polygon.points.size(); ++i) {
    const Vec2 a = polygon.points[i] - origin, b = polygon.points[(i + 1) % polygon.points.size()] - origin;
    const double cross = a.x * b.y - a.y * b.x;
    area += cross / 2;
    moment += cross / 6 * (a + b);
  }
  return origin + moment / area;
}

}  // namespace

double Random::uniform() {
  uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z = z ^ (z >> 31);
  return static_cast<double>(z >> 11) * 0x1p-53;
}

SampleBounds sample_bounds(const Scene& scene) {
  const auto bound = [&](const auto& geometry) {
    return std::visit([&](const auto& shape) { return area_bound(shape, scene.spacing); }, geometry);
  };
  SampleBounds bounds;
  for (const FluidShape& shape : scene.fluid) bounds.fluid += bound(shape.geometry);
  for (const BoundaryShape& shape : scene.boundary) bounds.boundary += bound(shape.geometry);
  return bounds;
}

Vec2 start_velocity(const FluidShape& shape, double spacing, Vec2 x) {
  const Vec2 centre =
      std::visit([&](const auto& geometry) { return centre_of(geometry, spacing); }, shape.geometry);
  return shape.velocity + shape.velocity_gradient * (x - centre);
}

Samples sample(const Scene& scene) {
  Samples samples;
  Places places(scene.spacing);
  sample_boundary(scene, samples, places);
  sample_fluid(scene, samples, places);
  if (scene.jitter > 0) {
    Random random(scene.seed);
    const auto offset = [&] { return (2 * random.uniform() - 1) * scene.jitter * scene.spacing; };
    for (Vec2& x : samples.fluid) {
      x.x += offset();
      x.y += offset();
    }
  }
  return samples;
}

}  // namespace sluice
