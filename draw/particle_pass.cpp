// Uploads of particles and the draw calls for them; the work is in shaders/draw/particles.vert and .frag.
#include "draw/particle_pass.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::draw {
namespace {

enum Colouring { colour_boundary, colour_speed, colour_map };

void fill_buffer(const gpu::Buffer& buffer, size_t bytes, const void* data) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  // A fresh store, so that the driver need not wait for the last frame to be drawn.
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

}  // namespace

View::View(glm::uvec2 picture, Vec2 view_min, Vec2 view_max, const Camera& camera)
    : size(picture), corner(view_min) {
  const Vec2 extent = view_max - view_min;
  const bool finite = std::isfinite(extent.x) && std::isfinite(extent.y);
  if (!finite || extent.x <= 0 || extent.y <= 0) {
    throw InputError(
        fmt::format("a picture cannot show the domain [{}, {}] - [{}, {}]; it must have a finite size",
                    view_min.x, view_min.y, view_max.x, view_max.y));
  }
  const Vec2 pixels(size);
  scale = std::min(pixels.x / extent.x, pixels.y / extent.y);
  const Vec2 margin = (pixels - scale * extent) / 2.0;
  scale *= camera.zoom;
  origin = camera.zoom * Vec2(margin.x, pixels.y - margin.y) + camera.shift;
  const auto edge = [](double at, double end) {
    return std::round(static_cast<float>(std::clamp(at, 0.0, end)));
  };
  const Vec2 low = camera.zoom * margin + camera.shift, high = camera.zoom * (pixels - margin) + camera.shift;
  box = {edge(low.x, pixels.x), edge(low.y, pixels.y), edge(high.x, pixels.x), edge(high.y, pixels.y)};
}

ParticlePass::ParticlePass(const gpu::Context& context, const View& view, double diameter,
                           ParticleShape shape)
    : context_(context),
      view_(view),
      diameter_(diameter),
      shape_(shape),
      program_(context, context.shaders().load("draw/particles.vert"),
               context.shaders().load("draw/particles.frag")),
      boundary_(context),
      fluid_(context),
      bar_(context) {
  look(view);
  describe(bar_, true, true);
}

void ParticlePass::look(const View& view) {
  context_.make_current();
  view_ = view;
  // A circle below one pixel is drawn with one pixel's diameter and as much paler as its area is smaller.
  const double radius = diameter_ * view_.scale / 2;
  radius_ = static_cast<float>(std::max(radius, 0.5));
  opacity_ = static_cast<float>(std::min(1.0, radius * radius / 0.25));
  half_extent_ = std::ceil(radius_) + 1;

  std::array<GLfloat, 2> point_sizes{};
  std::array<GLint, 2> viewport_limit{};
  glGetFloatv(GL_POINT_SIZE_RANGE, point_sizes.data());
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport_limit.data());
  // OpenGL drops a point whose centre leaves the viewport, even if half of its circle is still to be seen.
  // For points the viewport is therefore larger than the picture by half a sprite. Quads are cut exactly and
  // need no margin.
  const glm::vec2 size(view_.size);
  const glm::vec2 guarded = size + 2 * half_extent_;
  quads_ = shape_ == ParticleShape::quads || 2 * half_extent_ > point_sizes[1] ||
           guarded.x > static_cast<float>(viewport_limit[0]) ||
           guarded.y > static_cast<float>(viewport_limit[1]);
  viewport_ = quads_ ? glm::vec4(0, 0, size) : glm::vec4(-half_extent_, -half_extent_, guarded);

  describe(boundary_, quads_, false);
  describe(fluid_, quads_, true);
}

// Tells the vertex array where its attributes come from: one per vertex for points, one per instance for
// quads.
void ParticlePass::describe(const Cloud& cloud, bool quads, bool with_values) const {
  glBindVertexArray(cloud.vertices.name());
  const auto attach = [&](const char* name, const gpu::Buffer& buffer, GLint components) {
    const GLuint attribute = program_.attribute(name);
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glVertexAttribPointer(attribute, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    glVertexAttribDivisor(attribute, quads ? 1 : 0);
    glEnableVertexAttribArray(attribute);
  };
  attach("position", cloud.positions, 2);
  if (with_values) attach("value", cloud.values, 1);
}

// The corner is subtracted in double: a view far from the origin keeps its digits.
void ParticlePass::convert(std::span<const Vec2> positions) {
  positions_.resize(positions.size());
  std::ranges::transform(positions, positions_.begin(),
                         [&](const Vec2& position) { return glm::vec2(position - view_.corner); });
}

void ParticlePass::upload(Cloud& cloud) {
  cloud.count = positions_.size();
  fill_buffer(cloud.positions, positions_.size() * sizeof(glm::vec2), positions_.data());
  if (!values_.empty()) fill_buffer(cloud.values, values_.size() * sizeof(float), values_.data());
}

void ParticlePass::set_boundary(std::span<const Vec2> positions) {
  context_.make_current();
  convert(positions);
  values_.clear();
  upload(boundary_);
}

void ParticlePass::set_colouring(const Frame& frame) {
  const bool speed = frame.colour == Colour::speed;
  program_.set("colouring", static_cast<int>(speed ? colour_speed : colour_map));
  program_.set("value_range", glm::vec2(frame.low, frame.high));
}

void ParticlePass::draw(const Cloud& cloud) {
  if (cloud.count == 0) return;
  program_.use();
  program_.set("origin", glm::vec2(view_.origin));
  program_.set("scale", glm::vec2(static_cast<float>(view_.scale), static_cast<float>(-view_.scale)));
  program_.set("viewport", viewport_);
  program_.set("half_extent", glm::vec2(half_extent_));
  program_.set("quads", quads_);
  program_.set("radius", radius_);
  program_.set("opacity", opacity_);
  glViewport(static_cast<GLint>(viewport_.x), static_cast<GLint>(viewport_.y),
             static_cast<GLsizei>(viewport_.z), static_cast<GLsizei>(viewport_.w));
  glEnable(GL_PROGRAM_POINT_SIZE);
  glBindVertexArray(cloud.vertices.name());
  const auto count = static_cast<GLsizei>(cloud.count);
  if (quads_) {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  } else {
    glDrawArrays(GL_POINTS, 0, count);
  }
}

void ParticlePass::draw_boundary() {
  program_.set("colouring", static_cast<int>(colour_boundary));
  draw(boundary_);
}

void ParticlePass::upload_fluid(const Frame& frame) {
  if (frame.value.size() != frame.fluid.size()) {
    throw Error(
        fmt::format("a frame has {} particles but {} values", frame.fluid.size(), frame.value.size()));
  }
  convert(frame.fluid);
  values_.resize(frame.value.size());
  std::ranges::transform(frame.value, values_.begin(),
                         [](double value) { return static_cast<float>(value); });
  upload(fluid_);
}

void ParticlePass::draw_fluid(const Frame& frame, const Cloud* on_device) {
  if (on_device != nullptr)
    describe(*on_device, quads_, true);
  else
    upload_fluid(frame);
  set_colouring(frame);
  draw(on_device != nullptr ? *on_device : fluid_);
}

void ParticlePass::draw_colour_bar(const Box& box, const Frame& frame) {
  const auto columns = static_cast<size_t>(std::max(box.right - box.left, 2.0f));
  const bool speed = frame.colour == Colour::speed;
  const double low = speed ? 0 : frame.low;
  const double high = speed ? 1 : frame.high;
  positions_.clear();
  values_.clear();
  for (size_t k = 0; k < columns; ++k) {  // one quad per column of pixels, placed in pixels
    positions_.emplace_back(box.left + static_cast<float>(k) + 0.5f, (box.top + box.bottom) / 2);
    values_.push_back(
        static_cast<float>(low + (high - low) * static_cast<double>(k) / static_cast<double>(columns - 1)));
  }
  upload(bar_);
  set_colouring(frame);
  program_.use();
  program_.set("origin", glm::vec2(0));
  program_.set("scale", glm::vec2(1));
  program_.set("viewport", glm::vec4(0, 0, glm::vec2(view_.size)));
  program_.set("half_extent", glm::vec2(0.5f, (box.bottom - box.top) / 2));
  program_.set("quads", true);
  program_.set("radius", 0.0f);
  program_.set("opacity", 1.0f);
  glViewport(0, 0, static_cast<GLsizei>(view_.size.x), static_cast<GLsizei>(view_.size.y));
  glBindVertexArray(bar_.vertices.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(columns));
}

}  // namespace sluice::draw
