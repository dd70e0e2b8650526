// The progress line on a terminal: percent, simulated time, steps per second, dt, iterations, compression,
// time left.
#pragma once

#include <chrono>
#include <cstdint>

#include "core/simulator.hpp"

namespace sluice {

class Progress {
 public:
  /// Shows nothing when `quiet` or when standard error is not a terminal.
  Progress(uint64_t steps, double duration, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const StepReport& report);

 private:
  using Clock = std::chrono::steady_clock;
  uint64_t steps_;
  double duration_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace sluice
