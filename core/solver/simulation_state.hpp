// All that a run needs to go on from where another one stopped.
#pragma once

#include <cstdint>
#include <vector>

#include "core/solver/diagnostics.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Clock of a run. It is kept whole in checkpoints, so a change of it is a change of their format.
struct RunClock {
  uint64_t steps = 0;
  uint64_t steps_before = 0;  ///< steps and time before the last change of dt
  double time_before = 0;
  double dt = 0;       ///< length of the last step
  double next_dt = 0;  ///< length of the next step where steps adapt, unless it is cut short; else 0

  double time() const { return time_before + static_cast<double>(steps - steps_before) * dt; }
};

/// State of a run as the backend holds it, particles in the order of their ids: the bits, and not what they
/// stand for.
struct SimulationState {
  RunClock clock;
  Diagnostics diagnostics;  ///< what the last step reported
  std::vector<Vec2> x, v;
  std::vector<double> density, pressure;  ///< computed during the last step
};

/// Throws an InputError, with the file's name, when the state in it has not as many particles as the samples.
void require_particles(const std::string& file, const SimulationState& state, const Samples& samples);

/// The state as a start of `scene`, at step 0 and time 0; it is from a run of `before`.
SimulationState as_start(SimulationState state, const Scene& before, const Scene& scene);

}  // namespace sluice
