// Sampling of all shapes, the overlap check and the jitter of the start.
#include "sluice/sampling.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/scene/places.hpp"
#include "core/scene/random.hpp"
#include "core/scene/shapes.hpp"
#include "sluice/error.hpp"

namespace sluice {
namespace {

/// Beyond this many spacings from the origin a double no longer tells neighbouring places apart well.
constexpr double furthest = 0x1p40;

/// The points of a shape of either kind.
template <class Shape>
std::vector<Vec2> sampled(const Shape& shape, double h) {
  std::vector<Vec2> points =
      std::visit([&](const auto& geometry) { return points_of(geometry, h); }, shape.geometry);
  for (const Vec2 point : points) {
    if (std::abs(point.x) <= furthest * h && std::abs(point.y) <= furthest * h) continue;
    throw InputError(
        fmt::format("{}: {}: found a sample at ({:g}, {:g}), expected all within {:.3g} spacings of the "
                    "origin; move the scene nearer to it",
                    shape.where, shape.key, point.x, point.y, furthest));
  }
  return points;
}

void sample_boundary(const Scene& scene, Samples& samples, Places& places) {
  for (uint32_t s = 0; s < scene.boundary.size(); ++s) {
    for (const Vec2 point : sampled(scene.boundary[s], scene.spacing)) {
      if (places.near(point) != nullptr) {
        ++samples.boundary_dropped;
        continue;
      }
      places.add(point, s);
      samples.boundary.push_back(point);
      samples.boundary_shape.push_back(s);
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
    const std::vector<Vec2> points = sampled(shape, scene.spacing);
    if (points.empty()) {
      throw InputError(
          fmt::format("{}: {}: found no particle in it, expected a shape that holds at least one; make it "
                      "larger or particles.spacing smaller",
                      shape.where, shape.key));
    }
    const auto* given = std::get_if<Points>(&shape.geometry);
    if (given != nullptr) {
      samples.fluid_velocity.resize(samples.fluid.size());
      samples.fluid_velocity.insert(samples.fluid_velocity.end(), given->velocity.begin(),
                                    given->velocity.end());
    }
    for (const Vec2 point : points) {
      // What a run has left may be closer.
      const auto* other = given != nullptr ? nullptr : places.near(point);
      if (other != nullptr) refuse_overlap(scene, shape, point, *other);
      samples.fluid.push_back(point);
      samples.fluid_shape.push_back(s);
    }
    // Only later shapes can come too close: within a shape particles are a spacing apart.
    if (s + 1 == scene.fluid.size()) continue;
    for (const Vec2 point : points) places.add(point, static_cast<uint32_t>(scene.boundary.size()) + s);
  }
  if (!samples.fluid_velocity.empty()) samples.fluid_velocity.resize(samples.fluid.size());
}

}  // namespace

SampleBounds sample_bounds(const Scene& scene) {
  const auto bound = [&](const auto& shape) {
    return std::visit([&](const auto& geometry) { return count_bound(geometry, scene.spacing); },
                      shape.geometry);
  };
  SampleBounds bounds;
  for (const FluidShape& shape : scene.fluid) bounds.fluid += bound(shape);
  for (const BoundaryShape& shape : scene.boundary) bounds.boundary += bound(shape);
  return bounds;
}

Vec2 start_velocity(const FluidShape& shape, double spacing, Vec2 x) {
  const Vec2 centre =
      std::visit([&](const auto& geometry) { return centre_of(geometry, spacing); }, shape.geometry);
  return shape.velocity + shape.velocity_gradient * (x - centre);
}

Vec2 start_velocity(const Scene& scene, const Samples& samples, size_t i, Vec2 x) {
  const Vec2 v = start_velocity(scene.fluid[samples.fluid_shape[i]], scene.spacing, x);
  return samples.fluid_velocity.empty() ? v : v + samples.fluid_velocity[i];
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
