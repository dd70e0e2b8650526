// When the frames of a run are due.
#pragma once

#include <cstdint>

namespace sluice {

/// Clock of a run's frames: frame k shows the state after the first step whose time is at least k/fps, frame
/// 0 the start.
class FrameClock {
 public:
  /// Slack of a frame's time: a time that rounding keeps this much short of it counts as reached.
  static constexpr double slack = 1e-9;

  explicit FrameClock(double fps) : fps_(fps) {}

  /// Number of frames that are due at this time and were not before.
  uint64_t advance(double time) {
    const uint64_t before = count_;
    while (time >= static_cast<double>(count_) / fps_ - slack) ++count_;
    return count_ - before;
  }

 private:
  double fps_;
  uint64_t count_ = 0;
};

}  // namespace sluice
