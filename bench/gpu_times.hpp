// Times of the GPU backend, and of the CPU backend and the yardstick beside it. Whole steps are run, and the
// backend's own count of the seconds in each stage is read, so that a stage is timed where it stands in a
// run.
#pragma once

#include <array>
#include <cstdint>

#include "bench/cases.hpp"

namespace sluice::bench {

/// The fastest of several repetitions, each number on its own.
struct StepTimes {
  uint32_t n = 0;
  double neighbours = 0;  ///< mean number per particle
  double step = 0;        ///< seconds by the wall clock, reading back what the simulator reads
  double in_stages = 0;   ///< of these, what the backend counts for stages
  double sweep = 0;       ///< seconds in the stages of a sweep
  double sweep_bytes = 0;
  std::array<double, stage_count> stage{};  ///< seconds per run; NaN: not in the plan
};

StepTimes time_steps(Case& subject);

/// Whole IISPH steps of one size on both, in turns.
struct StepPair {
  uint32_t n = 0;
  double cpu = 0, gpu = 0;  ///< seconds per step, the fastest of several repetitions
};
StepPair compare_steps(uint32_t size, const gpu::Context& context);

/// Sweeps by the wall clock, up to and with reading back whether the solve is over, in turns.
struct SweepTimes {
  uint32_t n = 0;
  double yardstick = 0, cpu = 0, gpu = 0;  ///< seconds per sweep, the fastest of several repetitions
};

/// Throws when the yardstick computes something else than the GPU.
SweepTimes compare_sweeps(uint32_t size, const gpu::Context& context);

/// Bytes that a sweep of `n` particles with `entries` neighbours altogether has to move at the least, in
/// float, by the stage table: every field that a stage reads or writes, once.
double sweep_bytes(const Plan& plan, uint64_t n, uint64_t entries);

}  // namespace sluice::bench
