// Snapshot, or the GPU backend's buffers -> frame -> renderer.
#include "draw/painter.hpp"

#include <algorithm>
#include <vector>

#include "gpu/context.hpp"

namespace sluice::draw {
namespace {

/// What speed, density or pressure is multiplied by to be the value that a colour stands for.
double colour_unit(const Scene& scene, Colour colour, double dt) {
  switch (colour) {
    case Colour::speed: return dt / scene.spacing;
    case Colour::density: return 1 / scene.rest_density;
    case Colour::pressure: return 1;
  }
  return 0;
}

std::vector<double> colour_values(Colour colour, const Snapshot& state, double unit) {
  std::vector<double> values(state.x.size());
  for (size_t i = 0; i < values.size(); ++i) {
    switch (colour) {
      case Colour::speed: values[i] = unit * glm::length(state.v[i]); break;
      case Colour::density: values[i] = unit * state.density[i]; break;
      case Colour::pressure: values[i] = unit * state.pressure[i]; break;
    }
  }
  return values;
}

double depth_of(const Scene& scene, const Samples& samples) {
  const double g = glm::length(scene.gravity);
  if (g == 0) return 0;
  const auto height = [&](Vec2 x) { return -glm::dot(x, scene.gravity) / g; };
  const auto [low, high] = std::ranges::minmax_element(samples.fluid, {}, height);
  return height(*high) - height(*low) + scene.spacing;
}

}  // namespace

Painter::Painter(const gpu::Context& context, Outliving<Scene> scene, Outliving<Samples> samples,
                 glm::uvec2 size)
    : context_(context),
      scene_(scene),
      samples_(samples),
      renderer_(context, size, scene_.domain_min, scene_.domain_max, scene_.spacing),
      depth_(depth_of(scene_, samples_)) {
  renderer_.set_boundary(samples_.boundary);
}

/// Values at the ends of the colour bar, the same for all frames of a run so that pictures compare: density
/// within 5 % of rest; pressure up to that under the fluid's depth at the start, or, without gravity, the
/// largest of the frame.
std::pair<double, double> Painter::colour_range(Colour colour, double largest) const {
  if (colour == Colour::density) return {0.95, 1.05};
  if (depth_ == 0) return {0, largest > 0 ? largest : 1};
  return {0, scene_.rest_density * glm::length(scene_.gravity) * depth_};
}

void Painter::paint(Frame labels, double dt, const Snapshot& state) {
  const std::vector<double> values =
      colour_values(labels.colour, state, colour_unit(scene_, labels.colour, dt));
  labels.fluid = state.x;
  labels.value = values;
  const auto largest = std::ranges::max_element(values);
  std::tie(labels.low, labels.high) = colour_range(labels.colour, largest == values.end() ? 0 : *largest);
  renderer_.paint(labels);
}

void Painter::paint(Frame labels, double dt, const gpu::GpuBackend& backend) {
  if (!on_device_) on_device_.emplace(context_);
  on_device_->collect(backend, samples_.fluid.size(), labels.colour, colour_unit(scene_, labels.colour, dt));
  // Only pressure without gravity has a range of its own in every frame; asking waits for the device.
  const bool asks = labels.colour == Colour::pressure && depth_ == 0;
  std::tie(labels.low, labels.high) = colour_range(labels.colour, asks ? on_device_->largest() : 0);
  renderer_.paint(labels, &on_device_->cloud());
}

}  // namespace sluice::draw
