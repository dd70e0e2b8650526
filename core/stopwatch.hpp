// How long something took, and whether the machine had other things to do: without that, seconds mean little.
#pragma once

#include <optional>

namespace sluice {

/// Seconds of the parts of a run between start() and stop().
class Stopwatch {
 public:
  Stopwatch();

  void start();
  /// Ends the part that began with start(); returns its seconds by the wall clock.
  double stop();

  double wall() const { return wall_; }  ///< seconds by the wall clock
  double cpu() const { return cpu_; }    ///< seconds of processors, of all threads together

  /// Number of processors that other programs used on average since this was made, children of this one among
  /// them. Nothing where the system does not say, or for less than a second, in which it hardly can.
  std::optional<double> others() const;

 private:
  double wall_ = 0, cpu_ = 0;
  double wall_then_ = 0, cpu_then_ = 0;  ///< at start()
  double wall_first_, cpu_first_;
  std::optional<double> machine_first_;  ///< seconds that all processors had been busy
};

/// Whether others used so much that wall seconds are not to be compared with those of other runs.
bool was_busy(std::optional<double> others);

}  // namespace sluice
