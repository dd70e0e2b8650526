// Seconds per stage on the device.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/model/stages.hpp"

namespace sluice::gpu {

class Context;

/// Measures the time that stages take. On hardware by timestamp queries, read back when they are long done,
/// so that nothing waits. Where a processor plays the graphics card these mean nothing: there each stage is
/// waited for and a clock read.
class StageTimer {
 public:
  explicit StageTimer(const Context& context);
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
  std::unique_ptr<Queries> queries_;  ///< none: the clock is used
  double started_ = 0;
  std::array<double, stage_count> seconds_{};
};

}  // namespace sluice::gpu
