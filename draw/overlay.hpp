// Text and plain rectangles over a picture.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "draw/particle_pass.hpp"
#include "draw/program.hpp"
#include "gpu/gl_object.hpp"

namespace sluice::draw {

/// Collects text and rectangles, then draws them all. The font is DejaVu Sans, its size fits the picture;
/// characters outside Latin-1 and a few mathematical ones appear as '?'.
class Overlay {
 public:
  Overlay(const gpu::Context& context, glm::uvec2 picture);
  ~Overlay();

  /// Draws on pictures of this size from now on.
  void resize(glm::uvec2 picture);

  float font_size() const { return font_size_; }      ///< height of an em in pixels
  float line_height() const { return line_height_; }  ///< from baseline to baseline
  float ascent() const { return ascent_; }            ///< from the top of a line to its baseline
  float width(std::string_view text) const;

  void add_box(const Box& box, glm::vec4 colour);
  void add_text(float left, float top, std::string_view text, glm::vec4 colour);

  /// Draws what was added, in that order, and forgets it.
  void draw();

 private:
  struct Font;
  struct Quad {
    Box box;
    Box cut;
    glm::vec4 colour;
  };

  const gpu::Context& context_;
  glm::uvec2 picture_{};
  float font_size_ = 0, line_height_ = 0, ascent_ = 0;
  std::unique_ptr<Font> font_;
  Program program_;
  gpu::VertexArray vertices_;
  gpu::Buffer buffer_;
  gpu::Texture texture_;
  std::vector<Quad> quads_;
};

}  // namespace sluice::draw
