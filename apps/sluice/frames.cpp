// Snapshot, or the GPU backend's buffers -> frame -> PNG.
#include "apps/sluice/frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/sluice/machine.hpp"
#include "core/error.hpp"
#include "core/frame.hpp"
#include "core/image.hpp"
#include "core/text.hpp"
#include "gpu/device_fluid.hpp"
#include "gpu/renderer.hpp"

namespace sluice {
namespace {

/// Values at the ends of the colour bar, the same for all frames of a run so that pictures compare: density
/// within 5 % of rest; pressure up to that under the fluid's height at the start, or, without gravity, the
/// largest of the frame.
std::pair<double, double> colour_range(const Scene& scene, const Samples& samples, double largest) {
  if (scene.colour == Colour::density) return {0.95, 1.05};
  const double g = glm::length(scene.gravity);
  if (g == 0) return {0, largest > 0 ? largest : 1};
  const auto height = [&](Vec2 x) { return -glm::dot(x, scene.gravity) / g; };
  const auto [low, high] = std::minmax_element(samples.fluid.begin(), samples.fluid.end(),
                                               [&](Vec2 a, Vec2 b) { return height(a) < height(b); });
  return {0, scene.rest_density * g * (height(*high) - height(*low) + scene.spacing)};
}

std::string frame_name(uint64_t k) { return fmt::format("frame_{:06}.png", k); }

/// What speed, density or pressure is multiplied by to be the value that a colour stands for.
double colour_unit(const Scene& scene, double dt) {
  switch (scene.colour) {
    case Colour::speed: return dt / scene.spacing;
    case Colour::density: return 1 / scene.rest_density;
    case Colour::pressure: return 1;
  }
  return 0;
}

std::vector<double> colour_values(Colour colour, const Snapshot& snapshot, double unit) {
  std::vector<double> values(snapshot.x.size());
  for (size_t i = 0; i < values.size(); ++i) {
    switch (colour) {
      case Colour::speed: values[i] = unit * glm::length(snapshot.v[i]); break;
      case Colour::density: values[i] = unit * snapshot.density[i]; break;
      case Colour::pressure: values[i] = unit * snapshot.pressure[i]; break;
    }
  }
  return values;
}

std::vector<std::string> overlay_text(const Scene& scene, const Samples& samples, const StepReport& report,
                                      OverlayChoice overlay, double seconds_per_step) {
  if (overlay == OverlayChoice::none) return {};
  std::vector<std::string> lines = {scene.title,
                                    fmt::format("{}, dt {:g}", title_of(scene.method), report.dt),
                                    fmt::format("time {:.2f}", report.time)};
  if (scene.method == PressureMethod::iisph) lines.push_back(fmt::format("iterations {}", report.iterations));
  lines.push_back(fmt::format("particles {} + {}", samples.fluid.size(), samples.boundary.size()));
  if (overlay == OverlayChoice::all)
    lines.push_back(fmt::format("{:.2f} ms per step", 1e3 * seconds_per_step));
  return lines;
}

}  // namespace

struct FrameOutput::Drawing {
  const Scene& scene;
  const Samples& samples;
  gpu::Renderer renderer;
  PngWriter writer;
  const gpu::GpuBackend* backend;
  std::optional<gpu::DeviceFluid> on_device;  // with the GPU backend

  Drawing(const Scene& run_scene, const Samples& run_samples, Machine& machine)
      : scene(run_scene),
        samples(run_samples),
        renderer(machine.context(), scene.image_size, scene.domain_min, scene.domain_max, scene.spacing),
        backend(machine.gpu_backend()) {
    renderer.set_boundary(samples.boundary);
    if (backend != nullptr) on_device.emplace(machine.context(), scene.domain_min);
  }

  Image draw(Frame frame, double unit, const Snapshot& snapshot) {
    const std::vector<double> values = colour_values(scene.colour, snapshot, unit);
    frame.fluid = snapshot.x;
    frame.value = values;
    const auto largest = std::max_element(values.begin(), values.end());
    std::tie(frame.low, frame.high) = colour_range(scene, samples, largest == values.end() ? 0 : *largest);
    return renderer.draw(frame);
  }

  Image draw_on_device(Frame frame, double unit) {
    on_device->collect(*backend, samples.fluid.size(), scene.colour, unit);
    // Only pressure without gravity has a range of its own in every frame; asking waits for the device.
    const bool asks = scene.colour == Colour::pressure && scene.gravity == Vec2(0);
    std::tie(frame.low, frame.high) = colour_range(scene, samples, asks ? on_device->largest() : 0);
    return renderer.draw(frame, &on_device->cloud());
  }
};

FrameOutput::FrameOutput(const Scene& scene, const Samples& samples, const std::filesystem::path& folder,
                         OverlayChoice overlay, Machine& machine)
    : scene_(scene), samples_(samples), folder_(folder), overlay_(overlay) {
  drawing_ = std::make_unique<Drawing>(scene, samples, machine);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw EnvironmentError(fmt::format("{}: the folder can't be created: {}; choose another for --frames",
                                       folder.string(), error.message()));
  }
}

FrameOutput::~FrameOutput() = default;

uint64_t FrameOutput::older_pictures() const {
  uint64_t older = 0;
  for (uint64_t k = count_; std::filesystem::exists(folder_ / frame_name(k)); ++k) ++older;
  return older;
}

void FrameOutput::show(const Simulator& simulator, const StepReport& report, double seconds_per_step) {
  const auto due = [&] { return report.time >= static_cast<double>(count_) / scene_.fps - 1e-9; };
  if (!due()) return;
  Frame frame;
  frame.colour = scene_.colour;
  frame.text = overlay_text(scene_, samples_, report, overlay_, seconds_per_step);
  frame.colour_bar = scene_.colour != Colour::speed && overlay_ != OverlayChoice::none;
  const double unit = colour_unit(scene_, report.dt);
  // The buffers hold what a failed step led to, which may not be finite; the snapshot is fit to be shown.
  const bool on_device = drawing_->on_device && !simulator.failure();
  const Image image =
      on_device ? drawing_->draw_on_device(frame, unit) : drawing_->draw(frame, unit, simulator.snapshot());
  for (; due(); ++count_) drawing_->writer.write(folder_ / frame_name(count_), image);
}

void FrameOutput::finish() { drawing_->writer.finish(); }

}  // namespace sluice
