// Snapshot -> frame -> PNG.
#include "apps/sluice/frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "core/image.hpp"
#include "core/text.hpp"
#include "gpu/context.hpp"
#include "gpu/renderer.hpp"

namespace sluice {
namespace {

/// Values at the ends of the colour bar, the same for all frames of a run so that pictures compare: density
/// within 5 % of rest; pressure up to that under the fluid's height at the start, or, without gravity, the
/// largest of the frame.
std::pair<double, double> colour_range(const Scene& scene, const Samples& samples, const Snapshot& snapshot) {
  if (scene.colour == Colour::density) return {0.95, 1.05};
  const double g = glm::length(scene.gravity);
  if (g == 0) {
    const double largest = *std::max_element(snapshot.pressure.begin(), snapshot.pressure.end());
    return {0, largest > 0 ? largest : 1};
  }
  const auto height = [&](Vec2 x) { return -glm::dot(x, scene.gravity) / g; };
  const auto [low, high] = std::minmax_element(samples.fluid.begin(), samples.fluid.end(),
                                               [&](Vec2 a, Vec2 b) { return height(a) < height(b); });
  return {0, scene.rest_density * g * (height(*high) - height(*low) + scene.spacing)};
}

std::string frame_name(uint64_t k) { return fmt::format("frame_{:06}.png", k); }

std::vector<double> colour_values(const Scene& scene, const Snapshot& snapshot, double dt) {
  std::vector<double> values(snapshot.x.size());
  for (size_t i = 0; i < values.size(); ++i) {
    switch (scene.colour) {
      case Colour::speed: values[i] = glm::length(snapshot.v[i]) * dt / scene.spacing; break;
      case Colour::density: values[i] = snapshot.density[i] / scene.rest_density; break;
      case Colour::pressure: values[i] = snapshot.pressure[i]; break;
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
  gpu::Renderer renderer;
  PngWriter writer;

  Drawing(const Scene& scene, const gpu::Context& context)
      : renderer(context, scene.image_size, scene.domain_min, scene.domain_max, scene.spacing) {}
};

FrameOutput::FrameOutput(const Scene& scene, const Samples& samples, const std::filesystem::path& folder,
                         OverlayChoice overlay, const gpu::Context& context)
    : scene_(scene), samples_(samples), folder_(folder), overlay_(overlay) {
  drawing_ = std::make_unique<Drawing>(scene, context);
  drawing_->renderer.set_boundary(samples.boundary);
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
  const Snapshot snapshot = simulator.snapshot();
  const std::vector<double> values = colour_values(scene_, snapshot, report.dt);
  Frame frame;
  frame.fluid = snapshot.x;
  frame.value = values;
  frame.colour = scene_.colour;
  std::tie(frame.low, frame.high) = colour_range(scene_, samples_, snapshot);
  frame.text = overlay_text(scene_, samples_, report, overlay_, seconds_per_step);
  frame.colour_bar = scene_.colour != Colour::speed && overlay_ != OverlayChoice::none;
  const Image image = drawing_->renderer.draw(frame);
  for (; due(); ++count_) drawing_->writer.write(folder_ / frame_name(count_), image);
}

void FrameOutput::finish() { drawing_->writer.finish(); }

}  // namespace sluice
