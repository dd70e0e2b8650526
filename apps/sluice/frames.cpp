// Draws a frame at most once, fetches its state at most once, and hands both on.
#include "apps/sluice/frames.hpp"

#include <fmt/format.h>

#include "apps/sluice/overlay_text.hpp"
#include "apps/sluice/warnings.hpp"
#include "core/attempts.hpp"
#include "core/text.hpp"
#include "draw/frame.hpp"
#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

std::string frame_name(uint64_t k) { return fmt::format("frame_{:06}.png", k); }

}  // namespace

PictureFolder::PictureFolder(const std::filesystem::path& folder, uint64_t first)
    : folder_(folder), first_(first), next_(first) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw EnvironmentError(fmt::format("{}: the folder can't be created: {}; choose another for --frames",
                                       folder.string(), error.message()));
  }
}

void PictureFolder::write(draw::Image image) {
  writer_.write(folder_ / frame_name(next_++), std::move(image));
}

void PictureFolder::flush() { writer_.flush(); }

void PictureFolder::finish() { writer_.finish(); }

uint64_t PictureFolder::older_pictures() const {
  uint64_t older = 0;
  for (uint64_t k = next_; std::filesystem::exists(folder_ / frame_name(k)); ++k) ++older;
  return older;
}

FrameOutputs::FrameOutputs(const FrameOptions& options, const Scene& scene, const Samples& samples,
                           Precision precision, const std::string& device,
                           const std::function<const gpu::Context&()>& context, const FramesBefore& before)
    : options_(options), scene_(scene), samples_(samples) {
  if (options.pictures())
    painter_ = std::make_unique<draw::Painter>(context(), scene, samples, scene.image_size);
  if (options.frames) pictures_.emplace(*options.frames, before.count);
  if (options.video) video_.emplace(*options.video, scene.image_size, scene.fps * options.speed);
  if (options.vtk) vtk_.emplace(*options.vtk, samples.boundary, precision, before.count, before.time);
  if (options.record) recording_.emplace(*options.record, scene, precision, device);
}

const draw::Image& FrameOutputs::picture(const StepReport& report, double seconds_per_step,
                                         const StateSource& source) {
  if (image_step_ == report.step) return image_;
  draw::Frame labels;
  labels.colour = scene_.colour;
  labels.text = overlay_text(scene_, samples_, report, options_.overlay, seconds_per_step);
  labels.colour_bar = scene_.colour != Colour::speed && options_.overlay != OverlayChoice::none;
  if (source.on_device != nullptr) {
    painter_->paint(std::move(labels), report.dt, *source.on_device);
  } else {
    painter_->paint(std::move(labels), report.dt, state(report, source));
  }
  image_ = painter_->renderer().read();
  image_step_ = report.step;
  return image_;
}

const Snapshot& FrameOutputs::state(const StepReport& report, const StateSource& source) {
  if (state_step_ != report.step) state_ = source.snapshot();
  state_step_ = report.step;
  return state_;
}

// The recording first: whatever else fails, the run can be had from it.
void FrameOutputs::add(const StepReport& report, double seconds_per_step, const StateSource& source) {
  if (recording_) recording_->add(report, seconds_per_step, state(report, source));
  if (vtk_) vtk_->add(report.time, state(report, source));
  if (pictures_) pictures_->write(picture(report, seconds_per_step, source));
  if (video_) video_->write(picture(report, seconds_per_step, source));
}

void FrameOutputs::flush() {
  if (pictures_) pictures_->flush();
}

void FrameOutputs::finish() {
  Attempts attempt;
  if (recording_) attempt([&] { recording_->commit(); });
  if (vtk_) attempt([&] { vtk_->finish(); });
  if (video_) attempt([&] { video_->finish(); });
  if (pictures_) attempt([&] { pictures_->finish(); });
  attempt.end();
}

void FrameOutputs::tell(bool quiet) const {
  if (quiet) return;
  const auto older = [&](uint64_t count, const char* what, const std::filesystem::path& folder) {
    if (count == 0) return;
    warn(quiet, fmt::format("{} more {} in {} are from an earlier run; delete them before you use the folder",
                            count, what, folder.string()));
  };
  if (pictures_) {
    fmt::print("{} pictures in {}\n", pictures_->count(), options_.frames->string());
    older(pictures_->older_pictures(), "pictures", *options_.frames);
  }
  const auto none = [](const std::filesystem::path& file) {
    fmt::print("no frame was due, so there is no {}\n", file.string());
  };
  if (video_ && video_->count() == 0) {
    none(*options_.video);
  } else if (video_) {
    fmt::print("{} pictures, {:g} seconds, in {}\n", video_->count(),
               static_cast<double>(video_->count()) / (scene_.fps * options_.speed),
               options_.video->string());
  }
  if (vtk_) {
    fmt::print("{} frames for ParaView in {}\n", vtk_->count(), (*options_.vtk / "fluid.pvd").string());
    older(vtk_->older_files(), "files", *options_.vtk);
  }
  if (recording_ && recording_->frames() == 0) {
    none(*options_.record);
  } else if (recording_) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(*options_.record, error);  // a pipe has none
    fmt::print("{} frames{} in {}\n", recording_->frames(),
               error ? "" : fmt::format(", {},", bytes_text(static_cast<double>(bytes))),
               options_.record->string());
  }
}

}  // namespace sluice::app
