// What a step reports, what the fluid is like after it, and why a run ended early.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/solver/diagnostics.hpp"

namespace sluice {

struct StepReport {
  uint64_t step = 0;  ///< 1 for the first
  double time = 0;    ///< at the end of the step
  double dt = 0;
  uint32_t repeats = 0;     ///< times an adaptive step was done again with a shorter dt
  uint32_t iterations = 0;  ///< 0 where pressure comes from a state equation
  double residual = 0;      ///< the last e
  bool converged = true;
  Diagnostics diagnostics;
};

/// Reason why a run is invalid, with the place and the moment.
struct Failure {
  uint64_t step = 0;
  double time = 0;
  uint32_t id = 0;
  Vec2 x{};  ///< last finite position of that particle
  std::string reason;
  bool collapsed = false;  ///< an adaptive step had to be shorter than it may be
};

/// State of the fluid, particles in the order of their ids.
struct Snapshot {
  std::vector<Vec2> x, v;
  std::vector<double> density, pressure;  ///< computed during the step that led to this state
  uint64_t step = 0;                      ///< the step that led to this state; 0 at the start
};

}  // namespace sluice
