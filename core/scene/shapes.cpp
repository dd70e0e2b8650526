// Lattices, walls and centres of shapes.
#include "core/scene/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sluice {
namespace {

struct Box {
  Vec2 min, max;
};

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

}  // namespace

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

std::vector<Vec2> points_of(const Disc& disc, double h) {
  const double limit = disc.radius * (1 - 1e-9);
  return lattice(disc.centre, {disc.centre - disc.radius, disc.centre + disc.radius}, h,
                 [&](Vec2 point) { return glm::length(point - disc.centre) < limit; });
}

std::vector<Vec2> points_of(const Polygon& polygon, double h) {
  return lattice(polygon.points.front(), bounding_box(polygon.points), h,
                 [&](Vec2 point) { return inside_polygon(polygon.points, point, 1e-9 * h); });
}

std::vector<Vec2> points_of(const Points& points, double) { return points.at; }

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

double count_bound(const Rect& rect, double) { return double(rect.count.x) * double(rect.count.y); }
double count_bound(const Disc& disc, double h) { return std::numbers::pi * std::pow(disc.radius / h + 1, 2); }
double count_bound(const Polygon& polygon, double h) {
  const Box box = bounding_box(polygon.points);
  const Vec2 n = (box.max - box.min) / h + 1.0;
  return n.x * n.y;
}
double count_bound(const Points& points, double) { return double(points.at.size()); }
double count_bound(const Container& box, double h) {
  const Vec2 n = (box.max - box.min) / h + 1.0;
  return box.layers * ((box.left + box.right) * n.y + (box.bottom + box.top) * n.x);
}
double count_bound(const Segment& segment, double h) {
  return segment.layers * (glm::length(segment.to - segment.from) / h + 1);
}

Vec2 centre_of(const Rect& rect, double h) { return rect.min + 0.5 * h * (Vec2(rect.count) - 1.0); }
Vec2 centre_of(const Disc& disc, double) { return disc.centre; }
Vec2 centre_of(const Points&, double) { return {}; }
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

}  // namespace sluice
