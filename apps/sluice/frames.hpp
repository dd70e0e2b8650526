// What is made of the frames of a run or of a recording: pictures, a film, files for ParaView, a recording.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "apps/sluice/options.hpp"
#include "draw/image.hpp"
#include "draw/painter.hpp"
#include "media/recording.hpp"
#include "media/video.hpp"
#include "media/vtk_series.hpp"
#include "sluice/sampling.hpp"

namespace sluice::app {

/// Folder of pictures: frame_000000.png, ...
class PictureFolder {
 public:
  /// Creates the folder. The first picture has the number `first`.
  explicit PictureFolder(const std::filesystem::path& folder, uint64_t first = 0);

  void write(draw::Image image);
  void flush();   ///< returns when all pictures so far have been written
  void finish();  ///< waits as flush() does; nothing may be written afterwards

  uint64_t count() const { return next_ - first_; }
  /// Number of pictures of an earlier, longer run that follow this run's own in the folder.
  uint64_t older_pictures() const;

 private:
  std::filesystem::path folder_;
  draw::PngWriter writer_;
  uint64_t first_, next_;
};

/// Frames of a run that were due up to the checkpoint from which it goes on.
struct FramesBefore {
  uint64_t count = 0;
  double time = 0;  ///< time of the checkpoint
};

/// Source of a frame's particles.
struct StateSource {
  std::function<Snapshot()> snapshot;
  const gpu::GpuBackend* on_device = nullptr;  ///< if set, pictures are drawn from its buffers
};

class FrameOutputs {
 public:
  /// Opens what `options` ask for, so that a folder that is not there is known at once. `context` is called
  /// if pictures are drawn. Scene and samples outlive this.
  FrameOutputs(const FrameOptions& options, const Scene& scene, const Samples& samples, Precision precision,
               const std::string& device, const std::function<const gpu::Context&()>& context,
               const FramesBefore& before = {});

  /// Adds the next frame. One of the same step as the last is written again, but not drawn again.
  void add(const StepReport& report, double seconds_per_step, const StateSource& source);

  /// Waits until the pictures so far have been written.
  void flush();

  /// Waits until everything is on disk and has its name. Where one output can't be finished, the others still
  /// are, and then the failure is thrown.
  void finish();

  /// Says what was written, for people, and warns where files of an earlier run are in the way.
  void tell(bool quiet) const;

 private:
  const draw::Image& picture(const StepReport& report, double seconds_per_step, const StateSource& source);
  const Snapshot& state(const StepReport& report, const StateSource& source);

  FrameOptions options_;
  const Scene& scene_;
  const Samples& samples_;
  std::optional<PictureFolder> pictures_;
  std::optional<media::VideoFile> video_;
  std::optional<media::VtkSeries> vtk_;
  std::optional<media::RecordingWriter> recording_;
  std::unique_ptr<draw::Painter> painter_;
  draw::Image image_;  // of the last step shown
  Snapshot state_;     // the same
  std::optional<uint64_t> image_step_, state_step_;
};

}  // namespace sluice::app
