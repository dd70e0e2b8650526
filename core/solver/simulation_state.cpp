// Positions count from the domain's corner, which may be another.
#include "core/solver/simulation_state.hpp"

namespace sluice {

SimulationState as_start(SimulationState state, const Scene& before, const Scene& scene) {
  state.clock = {.dt = scene.dt};
  state.diagnostics = {};
  if (before.domain_min != scene.domain_min)
    for (Vec2& x : state.x) x += before.domain_min - scene.domain_min;
  return state;
}

}  // namespace sluice
