// Pictures of a run: decides when a frame is due, what it shows, and hands it to the renderer and the PNG
// writer.
#pragma once

#include <filesystem>
#include <memory>

#include "apps/sluice/options.hpp"
#include "core/sampling.hpp"
#include "core/simulator.hpp"

namespace sluice {

class Machine;

class FrameOutput {
 public:
  /// Creates the folder; draws in the context of `machine`, which outlives this and runs the simulation.
  FrameOutput(const Scene& scene, const Samples& samples, const std::filesystem::path& folder,
              OverlayChoice overlay, Machine& machine);
  ~FrameOutput();

  /// Draws the frames that are due after this step; frame k is due once time >= k/fps. Step 0 is the start.
  void show(const Simulator& simulator, const StepReport& report, double seconds_per_step);

  /// Returns when all pictures are on disk.
  void finish();

  uint64_t count() const { return count_; }  ///< pictures so far
  /// Pictures of an earlier, longer run that follow this run's own in the folder.
  uint64_t older_pictures() const;

 private:
  struct Drawing;
  const Scene& scene_;
  const Samples& samples_;
  std::filesystem::path folder_;
  OverlayChoice overlay_;
  std::unique_ptr<Drawing> drawing_;
  uint64_t count_ = 0;
};

}  // namespace sluice
