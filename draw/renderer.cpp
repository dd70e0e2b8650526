// The framebuffer of a picture and the order in which its parts are drawn. The framebuffer's first row is the
// picture's top row: y is turned around when particles are placed, not when the pixels are read.
#include "draw/renderer.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::draw {
namespace {

// A picture's size is checked before anything is made for it.
glm::uvec2 checked_size(const gpu::Context& context, glm::uvec2 size) {
  context.make_current();
  GLint limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  const auto largest = static_cast<uint32_t>(limit);
  if (size.x < smallest_picture || size.y < smallest_picture || size.x > largest || size.y > largest) {
    throw InputError(
        fmt::format("a picture of {} x {} pixels is not possible; choose {} to {} in each direction ({})",
                    size.x, size.y, smallest_picture, largest, context.renderer()));
  }
  return size;
}

void clear(const Box& box, float grey) {
  glScissor(static_cast<GLint>(box.left), static_cast<GLint>(box.top),
            static_cast<GLsizei>(box.right - box.left), static_cast<GLsizei>(box.bottom - box.top));
  glEnable(GL_SCISSOR_TEST);
  glClearColor(grey, grey, grey, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

struct Renderer::State {
  State(const gpu::Context& gl, glm::uvec2 picture, Vec2 view_min, Vec2 view_max, double diameter,
        ParticleShape shape)
      : context(gl),
        size(checked_size(gl, picture)),
        low(view_min),
        high(view_max),
        view(picture, view_min, view_max),
        pixels(gl),
        framebuffer(gl),
        particles(gl, view, diameter, shape),
        overlay(gl, picture) {
    make_pixels();
  }

  void make_pixels() {
    glBindRenderbuffer(GL_RENDERBUFFER, pixels.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, static_cast<GLsizei>(size.x),
                          static_cast<GLsizei>(size.y));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels.name());
    context.check("making a picture");
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw EnvironmentError(
          fmt::format("{} cannot draw into a picture of {} x {} pixels; choose a smaller one",
                      context.renderer(), size.x, size.y));
    }
  }

  // The members that follow are deleted with the right context current, whatever was current before.
  ~State() { context.make_current(); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void draw_background() const {
    clear({0, 0, static_cast<float>(size.x), static_cast<float>(size.y)}, 0.93f);
    clear(view.box, 1.0f);
  }

  Image read() const {
    Image image{size.x, size.y, std::vector<uint8_t>(size_t{size.x} * size.y * 3)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, static_cast<GLsizei>(size.x), static_cast<GLsizei>(size.y), GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data());
    return image;
  }

  const gpu::Context& context;
  glm::uvec2 size;
  Vec2 low, high;
  Camera camera;
  View view;
  gpu::Renderbuffer pixels;
  gpu::Framebuffer framebuffer;
  ParticlePass particles;
  Overlay overlay;
  Panels panels;
};

Renderer::Renderer(const gpu::Context& context, glm::uvec2 size, Vec2 view_min, Vec2 view_max,
                   double diameter, ParticleShape shape)
    : state_(std::make_unique<State>(context, size, view_min, view_max, diameter, shape)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::set_boundary(std::span<const Vec2> positions) { state_->particles.set_boundary(positions); }

const Panels& Renderer::panels() const { return state_->panels; }

void Renderer::look(glm::uvec2 size, const Camera& camera) {
  State& state = *state_;
  if (size == state.size && camera == state.camera) return;
  const View view(checked_size(state.context, size), state.low, state.high, camera);
  if (size != state.size) {
    state.size = size;
    state.make_pixels();
    state.overlay.resize(size);
  }
  state.view = view;
  state.camera = camera;
  state.particles.look(view);
}

Image Renderer::draw(const Frame& frame, const Cloud* on_device) {
  paint(frame, on_device);
  return read();
}

void Renderer::paint(const Frame& frame, const Cloud* on_device) {
  State& state = *state_;
  state.context.make_current();
  glBindFramebuffer(GL_FRAMEBUFFER, state.framebuffer.name());
  state.draw_background();
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  state.particles.draw_boundary();
  state.particles.draw_fluid(frame, on_device);
  state.panels = add_panels(state.overlay, state.size, frame);
  state.overlay.draw();
  if (state.panels.gradient) state.particles.draw_colour_bar(*state.panels.gradient, frame);
  glDisable(GL_BLEND);
  state.context.check("drawing a picture");
}

Image Renderer::read() const {
  state_->context.make_current();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->framebuffer.name());
  Image image = state_->read();
  state_->context.check("reading a picture");
  return image;
}

// A window's first row is its lowest, a picture's its top row.
void Renderer::show(glm::uvec2 at, uint32_t window_height) const {
  const State& state = *state_;
  state.context.make_current();
  const auto width = static_cast<GLint>(state.size.x), height = static_cast<GLint>(state.size.y);
  const auto left = static_cast<GLint>(at.x),
             top = static_cast<GLint>(window_height) - static_cast<GLint>(at.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state.framebuffer.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width, height, left, top, left + width, top - height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  state.context.check("showing a picture");
}

}  // namespace sluice::draw
