// Bounds of a scene, and the rules of the adaptive step.
#include "core/solver/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace sluice {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How fast steps become longer.
constexpr double growth = 1.1;
/// A step is repeated with so much of what would just have held, at least halved or so at most quartered.
constexpr double share_of_what_holds = 0.9, least_share = 0.25, largest_share = 0.7;

/// Potential of the external forces, per mass.
double potential(const Scene& scene, Vec2 x) {
  const Vec2 from_centre = x - scene.centre;
  return 0.5 * scene.central_force * glm::dot(from_centre, from_centre) - glm::dot(scene.gravity, x);
}

struct Extremes {
  double least = infinity, largest = -infinity;

  void add(double value) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
};

Extremes potentials(const Scene& scene, const std::vector<Vec2>& places) {
  Extremes extremes;
  for (const Vec2 x : places) extremes.add(potential(scene, x));
  return extremes;
}

/// g depth: the range of the potential over the fluid, less the gaps that no fluid fills, as below a drop
/// that is yet to fall.
double potential_depth(const Scene& scene, const std::vector<Vec2>& fluid) {
  std::vector<std::pair<double, Vec2>> levels;
  for (const Vec2 x : fluid) levels.emplace_back(potential(scene, x), x);
  std::sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double depth = 0;
  for (size_t i = 1; i < levels.size(); ++i) {
    const Vec2 a = external_acceleration(scene, levels[i].second);
    const double in_reach = 2 * scene.smoothing_length() * std::hypot(a.x, a.y);
    depth += std::min(levels[i].first - levels[i - 1].first, in_reach);
  }
  return depth;
}

}  // namespace

double StepBounds::safe() const {
  double shortest = infinity;
  for (const StepBound& bound : {viscous, sound, depth})
    shortest = std::min(shortest, bound.safe * bound.duration);
  return shortest;
}

Vec2 external_acceleration(const Scene& scene, Vec2 x) {
  return scene.gravity - scene.central_force * (x - scene.centre);
}

double speed_of_sound(const Scene& scene) {
  switch (scene.method) {
    case PressureMethod::ssph: return std::sqrt(scene.ssph->stiffness / scene.rest_density);
    case PressureMethod::wcsph: return std::sqrt(scene.wcsph->kappa);
    case PressureMethod::iisph: return infinity;
  }
  return infinity;
}

StepBound sound_bound(const Scene& scene) {
  const double duration = scene.spacing / speed_of_sound(scene);
  // Tait's equation stiffens as it is compressed.
  if (scene.method == PressureMethod::wcsph) return {duration, 0.75, 1.35};
  return {scene.method == PressureMethod::ssph ? duration : infinity, 1, 1.8};
}

StepBounds step_bounds(const Scene& scene, const Samples& samples) {
  const double h = scene.spacing;
  StepBounds bounds{{infinity, 0.4, 0.5}, sound_bound(scene), {infinity, 0.8, 0.8}};
  if (scene.viscosity_model == ViscosityModel::laplacian && scene.viscosity > 0)
    bounds.viscous.duration = h * h / scene.viscosity;
  if (scene.method == PressureMethod::iisph) {
    const double depth = potential_depth(scene, samples.fluid);
    if (depth > 0) bounds.depth.duration = h / std::sqrt(depth);
  }
  return bounds;
}

double largest_impact_speed(const Scene& scene, const Samples& samples) {
  const Extremes fluid = potentials(scene, samples.fluid), boundary = potentials(scene, samples.boundary);
  double fastest = 0;
  for (size_t i = 0; i < samples.fluid.size(); ++i) {
    const Vec2 v = start_velocity(scene, samples, i, samples.fluid[i]);
    fastest = std::max(fastest, std::hypot(v.x, v.y));
  }
  const double fall = std::max(fluid.largest - boundary.least, 0.0);
  return std::sqrt(fastest * fastest + 2 * fall);
}

double StepControl::longest(double speed, double acceleration) const {
  // v dt + a dt^2 = cfl h, in a form that does not divide by an acceleration of 0.
  const double move = limits_.cfl * h_;
  const double motion =
      2 * move / (speed + std::sqrt(speed * speed + 4 * acceleration * move));  // infinite at rest
  return std::max(std::min({motion, safe_, limits_.dt_max}), limits_.dt_min);
}

double StepControl::next(double dt, const Diagnostics& d) const {
  return std::max(std::min(longest(d.max_speed, d.max_speed_change / dt), growth * dt), limits_.dt_min);
}

std::optional<double> StepControl::shorter(double dt, const Diagnostics& d) const {
  if (dt <= limits_.dt_min) return std::nullopt;
  const double holding = d.finite() ? share_of_what_holds * limits_.cfl / d.cfl : 0;
  return std::max(dt * std::clamp(holding, least_share, largest_share), limits_.dt_min);
}

}  // namespace sluice
