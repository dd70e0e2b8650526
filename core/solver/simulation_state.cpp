// Positions count from the domain's corner, which may be another.
#include "core/solver/simulation_state.hpp"

#include <fmt/format.h>

#include "sluice/error.hpp"

namespace sluice {

void require_particles(const std::string& file, const SimulationState& state, const Samples& samples) {
  if (state.x.size() == samples.fluid.size()) return;
  throw InputError(fmt::format("{}: found {} particles, expected the {} of its scene; use another file", file,
                               state.x.size(), samples.fluid.size()));
}

SimulationState as_start(SimulationState state, const Scene& before, const Scene& scene) {
  state.clock = {.dt = scene.dt};
  state.diagnostics = {};
  if (before.domain_min != scene.domain_min)
    for (Vec2& x : state.x) x += before.domain_min - scene.domain_min;
  return state;
}

}  // namespace sluice
