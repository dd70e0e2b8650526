// Pictures of a scene: what speed, density or pressure a colour stands for, and where the fluid comes from.
#pragma once

#include "core/outliving.hpp"
#include "draw/device_fluid.hpp"
#include "draw/renderer.hpp"
#include "sluice/report.hpp"
#include "sluice/sampling.hpp"

namespace sluice::draw {

class Painter {
 public:
  /// Painter of pictures with `size` pixels. The context outlives it too.
  Painter(const gpu::Context& context, Outliving<Scene> scene, Outliving<Samples> samples, glm::uvec2 size);

  /// Paints the fluid of a snapshot. `labels` has the colour and what is written over the picture; `dt` is
  /// that of the step that led to it.
  void paint(Frame labels, double dt, const Snapshot& state);

  /// Paints the fluid from the buffers of a backend of the same context, as the last step left them: the same
  /// picture, without copying the state.
  void paint(Frame labels, double dt, const gpu::GpuBackend& backend);

  Renderer& renderer() { return renderer_; }

 private:
  std::pair<double, double> colour_range(Colour colour, double largest) const;

  const gpu::Context& context_;
  const Scene& scene_;
  const Samples& samples_;
  Renderer renderer_;
  std::optional<DeviceFluid> on_device_;  // made when first needed
  double depth_ = 0;                      // of the fluid at the start, along gravity
};

}  // namespace sluice::draw
