// The progress line on a terminal: percent, simulated time, steps per second, dt, iterations, how many did
// not converge, compression, time left.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/simulator.hpp"

namespace sluice {

class Progress {
 public:
  /// Of so many `units`, "steps" or "frames", which end at the simulated time `duration`. Shows nothing when
  /// `quiet` or when standard error is not a terminal. `before` of them were done by an earlier run.
  Progress(uint64_t total, double duration, std::string units, bool quiet, uint64_t before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of them, of which so many did not converge; the last is this.
  void show(uint64_t done, const StepReport& report, uint64_t not_converged = 0);

 private:
  using Clock = std::chrono::steady_clock;
  uint64_t total_, before_;
  double duration_;
  std::string units_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace sluice
