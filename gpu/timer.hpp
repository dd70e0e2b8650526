// Seconds per stage on the device.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/model/stages.hpp"

namespace sluice::gpu {

class Context;

/// Seconds between two timestamps in nanoseconds, subtracted as integers: where clocks count from 1970, a
/// double steps by 238 ns.
double seconds_between(uint64_t from, uint64_t to);

/// Measures the time that stages take. On hardware by timestamp queries, read back when they are long done,
/// so that nothing waits. Where a processor plays the graphics card these mean nothing: there each stage is
/// waited for and a clock read.
class StageTimer {
 public:
  /// Timer that measures nothing unless `timed`.
  StageTimer(const Context& context, bool timed);
  ~StageTimer();
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

  void begin();
  /// Counts the time since begin() for `stage`.
  void end(Stage stage);
  void reset();
  /// Seconds counted for `stage`; waits for what is still under way.
  double seconds(Stage stage);

 private:
  struct Queries;
  void collect(size_t keep);

  const Context& context_;
  bool timed_;
  std::unique_ptr<Queries> queries_;  ///< none: the clock is used
  double started_ = 0;
  std::array<double, stage_count> seconds_{};
};

}  // namespace sluice::gpu
