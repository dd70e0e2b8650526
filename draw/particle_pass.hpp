// Draws particles as anti-aliased circles, and the gradient of the colour bar with the same colours.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "draw/frame.hpp"
#include "draw/program.hpp"
#include "gpu/gl_object.hpp"

namespace sluice::draw {

/// A rectangle in pixels, y down from the picture's top.
struct Box {
  float left = 0, top = 0, right = 0, bottom = 0;
};

/// Camera for a closer look: the picture that shows the whole view is enlarged about its top left corner,
/// then moved.
struct Camera {
  double zoom = 1;
  Vec2 shift{};  ///< pixels, y down

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// Mapping of simulated positions to pixels: pixel = origin + scale * (position - corner), with scale.y
/// negative.
struct View {
  View(glm::uvec2 size, Vec2 view_min, Vec2 view_max, const Camera& camera = {});

  glm::uvec2 size;
  Vec2 corner;
  Vec2 origin;
  double scale;
  Box box;  ///< what of the view is in the picture, rounded to whole pixels
};

/// Shape that particles are drawn as. `automatic` takes point sprites, which are cheaper, while the driver's
/// are large enough.
enum class ParticleShape { automatic, quads };

/// Particles on the graphics card, in the order they are drawn.
struct Cloud {
  explicit Cloud(const gpu::Context& context) : vertices(context), positions(context), values(context) {}
  gpu::VertexArray vertices;
  gpu::Buffer positions;  ///< relative to the view's corner, two floats each
  gpu::Buffer values;     ///< values as in Frame, a float each
  size_t count = 0;
};

class ParticlePass {
 public:
  ParticlePass(const gpu::Context& context, const View& view, double diameter, ParticleShape shape);

  /// Draws with this view from now on; its corner is that of the first.
  void look(const View& view);

  void set_boundary(std::span<const Vec2> positions);
  void draw_boundary();
  /// Draws the fluid of the frame, or with `on_device` the particles that are there.
  void draw_fluid(const Frame& frame, const Cloud* on_device = nullptr);

  /// Fills the box with the frame's colours, from its lowest value at the left to its highest at the right.
  void draw_colour_bar(const Box& box, const Frame& frame);

 private:
  void describe(const Cloud& cloud, bool quads, bool with_values) const;
  void convert(std::span<const Vec2> positions);
  void upload(Cloud& cloud);
  void upload_fluid(const Frame& frame);
  void draw(const Cloud& cloud);
  void set_colouring(const Frame& frame);

  const gpu::Context& context_;
  View view_;
  double diameter_;
  ParticleShape shape_;
  Program program_;
  Cloud boundary_, fluid_, bar_;
  bool quads_ = false;
  float radius_ = 0, opacity_ = 1, half_extent_ = 0;
  glm::vec4 viewport_{};
  std::vector<glm::vec2> positions_;  // kept between frames, like the buffers
  std::vector<float> values_;
};

}  // namespace sluice::draw
