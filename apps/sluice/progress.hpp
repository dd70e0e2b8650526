// The progress line on a terminal: percent, simulated time, steps per second, dt, iterations, how many did
// not converge, compression, time left.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/solver/simulator.hpp"

namespace sluice::app {

class Progress {
 public:
  /// Progress in so many `units`, "steps" or "frames", or if `total` is 0 in as many as it takes to reach the
  /// simulated time `duration`. Shows nothing when `quiet` or when standard error is not a terminal. An
  /// earlier run did `before` of them, up to `time_before`.
  Progress(uint64_t total, double duration, std::string units, bool quiet, uint64_t before = 0,
           double time_before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows that `done` of them are done, of which so many did not converge; the last is this.
  void show(uint64_t done, const StepReport& report, uint64_t not_converged = 0);

 private:
  using Clock = std::chrono::steady_clock;
  /// Share of the whole that is done, from 0 to 1.
  double share(uint64_t count, double time) const;
  uint64_t total_, before_;
  double duration_, time_before_;
  std::string units_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace sluice::app
