// What is made of the frames of a run or of a recording: pictures, a film, files for ParaView, a recording.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "apps/sluice/options.hpp"
#include "core/scene/sampling.hpp"
#include "draw/image.hpp"
#include "draw/painter.hpp"
#include "media/recording.hpp"
#include "media/video.hpp"
#include "media/vtk_series.hpp"

namespace sluice::app {

/// Pictures in a folder: frame_000000.png, ...
class PictureFolder {
 public:
  /// Creates the folder. The first picture has the number `first`.
  explicit PictureFolder(const std::filesystem::path& folder, uint64_t first = 0);

  void write(draw::Image image);
  void flush();   ///< returns when all pictures so far have been written
  void finish();  ///< the same; nothing may be written afterwards

  uint64_t count() const { return next_ - first_; }
  /// Pictures of an earlier, longer run that follow this run's own in the folder.
  uint64_t older_pictures() const;

 private:
  std::filesystem::path folder_;
  draw::PngWriter writer_;
  uint64_t first_, next_;
};

/// Frames of a run that were due up to the checkpoint which it goes on from.
struct FramesBefore {
  uint64_t count = 0;
  double time = 0;  ///< of the checkpoint
};

/// Where a frame's particles come from.
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

  /// The next frame. One of the same step as the last is written again, but not drawn again.
  void add(const StepReport& report, double seconds_per_step, const StateSource& source);

  /// Returns when the pictures so far have been written.
  void flush();

  /// Returns when everything is on disk and has its name. Where one can't be, the others still are, and then
  /// the failure is thrown.
  void finish();

  /// What was written, for people, and a warning where files of an earlier run are in the way.
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
