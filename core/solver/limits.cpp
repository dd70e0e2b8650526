// The limits of viscosity, sound, depth and walls, and how they are told.
#include "core/solver/limits.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/solver/time_step.hpp"
#include "core/text.hpp"

namespace sluice {
namespace {

/// Layers of a wall; none for shapes that have no layers.
std::optional<uint32_t> layers_of(const BoundaryShape& shape) {
  if (const auto* container = std::get_if<Container>(&shape.geometry)) return container->layers;
  if (const auto* segment = std::get_if<Segment>(&shape.geometry)) return segment->layers;
  return std::nullopt;
}

}  // namespace

double least_dt(const Scene& scene) { return scene.adaptive ? scene.adaptive->dt_min : scene.dt; }

std::string stiffness_key(PressureMethod method) {
  return method == PressureMethod::wcsph ? "pressure.wcsph.kappa" : "pressure.ssph.stiffness";
}

std::vector<std::string> beyond_limits(const Scene& scene, const Samples& samples) {
  std::vector<std::string> found;
  if (scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > largest_alpha) {
    found.push_back(
        fmt::format("viscosity.coefficient is {:g}, and above about {:g} XSPH no longer smooths "
                    "velocities but overshoots; use a smaller one",
                    scene.viscosity, largest_alpha));
  }
  const std::string& dt = scene.dt_key;
  const StepBounds bounds = step_bounds(scene, samples);
  const auto durations = [&](const StepBound& bound) { return least_dt(scene) / bound.duration; };
  const auto beyond = [&](const StepBound& bound) { return durations(bound) > bound.largest; };
  if (beyond(bounds.viscous)) {
    found.push_back(
        fmt::format("viscosity.coefficient dt / spacing^2 is {:.2g}, above the limit of an explicit "
                    "viscosity, about {:g}; use a smaller {} or viscosity.coefficient",
                    durations(bounds.viscous), bounds.viscous.largest, dt));
  }
  if (beyond(bounds.sound)) {
    found.push_back(
        fmt::format("sound travels {:.2g} spacings in a step, and above about {:g} a state equation "
                    "tends to blow up; use a smaller {} or {}",
                    durations(bounds.sound), bounds.sound.largest, dt, stiffness_key(scene.method)));
  }
  if (beyond(bounds.depth)) {
    found.push_back(
        fmt::format("dt sqrt(g depth) / spacing is {:.2g}, and above about {:g} the pressure of deep fluid "
                    "pushes particles through the floor; use a smaller {}",
                    durations(bounds.depth), bounds.depth.largest, dt));
  }
  const double impact = largest_impact_speed(scene, samples);
  if (!samples.boundary.empty() && speed_of_sound(scene) < impact) {
    found.push_back(
        fmt::format("the speed of sound is {:.3g}, and fluid may hit a wall at {:.3g}; below that it goes "
                    "through walls; use a larger {}",
                    speed_of_sound(scene), impact, stiffness_key(scene.method)));
  }
  if (scene.boundary_model != BoundaryModel::mirror) return found;
  for (const BoundaryShape& shape : scene.boundary) {
    const auto layers = layers_of(shape);
    if (!layers || *layers >= 3) continue;
    found.push_back(
        fmt::format("{}.layers is {}, and mirror samples fill the kernel with 3; thinner walls leak, "
                    "use more or boundary.model \"akinci\"",
                    shape.key, *layers));
  }
  return found;
}

}  // namespace sluice
