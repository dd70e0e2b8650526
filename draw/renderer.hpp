// Pictures of particles: one circle each, coloured by speed, density or pressure, with text and a colour bar.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "draw/frame.hpp"
#include "draw/image.hpp"
#include "draw/panels.hpp"

namespace sluice::gpu {
class Context;
}

namespace sluice::draw {

constexpr uint32_t smallest_picture = 16;  ///< pixels in each direction

/// Draws frames of one size and view. The same frame gives the same bytes.
class Renderer {
 public:
  /// Fits the view [view_min, view_max] into the middle of the picture and keeps its proportions; what
  /// remains of the picture is shaded. `diameter` is a circle's, in units of the view. InputError when the
  /// picture is below 16 pixels or beyond the driver's limit, or the view is empty. The context outlives the
  /// renderer.
  Renderer(const gpu::Context& context, glm::uvec2 size, Vec2 view_min, Vec2 view_max, double diameter,
           ParticleShape shape = ParticleShape::automatic);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Sets the boundary's positions for all frames to come; it is drawn in grey below the fluid.
  void set_boundary(std::span<const Vec2> positions);

  /// Draws pictures of this size, and looks at them through this camera, from now on. Errors as of the
  /// constructor.
  void look(glm::uvec2 size, const Camera& camera);

  /// Draws a frame. With `on_device`, in the same context, the fluid is what is there, and the frame's own is
  /// not read.
  Image draw(const Frame& frame, const Cloud* on_device = nullptr);

  /// Parts of draw(): paint() draws and leaves the picture on the graphics card; read() reads it from there;
  /// show() copies it into the window, its top left corner at this pixel of a window of that height.
  void paint(const Frame& frame, const Cloud* on_device = nullptr);
  Image read() const;
  void show(glm::uvec2 at, uint32_t window_height) const;

  /// The panels of the last frame.
  const Panels& panels() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sluice::draw
