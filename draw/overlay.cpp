// The overlay's font, baked by stb_truetype (compiled in this file only) into one texture, and its draw call.
#include "draw/overlay.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gpu/context.hpp"
#include "gpu/embedded.hpp"
#include "sluice/error.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>
#pragma GCC diagnostic pop

namespace sluice::draw {
namespace {

constexpr int atlas_width = 1024;
constexpr int atlas_height = 1024;  // enough for every size up to 22 pixels

// ASCII, Latin-1, and what titles and formulas need beyond; ascending.
std::vector<int> code_points() {
  std::vector<int> result;
  for (int code = 0x20; code < 0x7f; ++code) result.push_back(code);
  for (int code = 0xa0; code <= 0xff; ++code) result.push_back(code);
  for (int code = 0x391; code <= 0x3c9; ++code) result.push_back(code);  // Greek
  for (const int code : {0x2013, 0x2014, 0x2018, 0x2019, 0x201c, 0x201d, 0x2026, 0x2080, 0x2202, 0x2207,
                         0x2211, 0x2212, 0x221a, 0x221e, 0x2248, 0x2260, 0x2264, 0x2265}) {
    result.push_back(code);
  }
  return result;
}

// The next character of UTF-8 text, which is cut from the text; bytes that are no UTF-8 give 0.
int next_character(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (lead < 0x80) return lead;
  const size_t more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < more) return 0;
  int code = lead & (0x3f >> more);
  for (size_t k = 0; k < more; ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if ((byte & 0xc0) != 0x80) return 0;
    code = (code << 6) | (byte & 0x3f);
  }
  text.remove_prefix(more);
  return code;
}

// Small enough to leave room for the fluid, in whole pixels.
float font_size_for(glm::uvec2 picture) {
  const glm::vec2 size(picture);
  return std::clamp(std::round(std::min(size.y / 45, size.x / 26)), 11.0f, 22.0f);
}

}  // namespace

struct Overlay::Font {
  std::vector<int> codes = code_points();
  std::vector<stbtt_packedchar> glyphs = std::vector<stbtt_packedchar>(codes.size());
  std::vector<uint8_t> atlas = std::vector<uint8_t>(size_t{atlas_width} * atlas_height);

  explicit Font(float size);

  int glyph(int code) const {
    const auto found = std::ranges::lower_bound(codes, code);
    if (found == codes.end() || *found != code) return '?' - 0x20;
    return static_cast<int>(found - codes.begin());
  }
};

Overlay::Font::Font(float size) {
  const std::string_view file = gpu::embedded_file("DejaVuSans.ttf");
  stbtt_pack_context pack{};
  stbtt_pack_range range{};
  range.font_size = STBTT_POINT_SIZE(size);
  range.array_of_unicode_codepoints = codes.data();
  range.num_chars = static_cast<int>(codes.size());
  range.chardata_for_range = glyphs.data();
  bool done =
      !file.empty() && stbtt_PackBegin(&pack, atlas.data(), atlas_width, atlas_height, 0, 1, nullptr) != 0;
  if (done) {
    stbtt_PackSetOversampling(&pack, 3, 1);  // letters may then start at a third of a pixel
    done =
        stbtt_PackFontRanges(&pack, reinterpret_cast<const unsigned char*>(file.data()), 0, &range, 1) != 0;
    stbtt_PackEnd(&pack);
  }
  if (!done) throw Error("the font inside this program cannot be used; build it again");
}

Overlay::Overlay(const gpu::Context& context, glm::uvec2 picture)
    : context_(context),
      program_(context, context.shaders().load("draw/overlay.vert"),
               context.shaders().load("draw/overlay.frag")),
      vertices_(context),
      buffer_(context),
      texture_(context) {
  resize(picture);
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const auto attach = [&](const char* name, size_t offset) {
    const GLuint attribute = program_.attribute(name);
    glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, sizeof(Quad),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(attribute, 1);
    glEnableVertexAttribArray(attribute);
  };
  attach("box", offsetof(Quad, box));
  attach("cut", offsetof(Quad, cut));
  attach("tint", offsetof(Quad, colour));
  program_.set("font", 0);
}

void Overlay::resize(glm::uvec2 picture) {
  context_.make_current();
  picture_ = picture;
  program_.set("picture", glm::vec2(picture));
  const float font_size = font_size_for(picture);
  if (font_size == font_size_) return;
  font_size_ = font_size;
  font_ = std::make_unique<Font>(font_size_);
  line_height_ = std::round(font_size_ * 1.3f);
  ascent_ = std::round(font_size_ * 1.0f);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas_width, atlas_height, 0, GL_RED, GL_UNSIGNED_BYTE,
               font_->atlas.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

Overlay::~Overlay() = default;

float Overlay::width(std::string_view text) const {
  float sum = 0;
  while (!text.empty())
    sum += font_->glyphs[static_cast<size_t>(font_->glyph(next_character(text)))].xadvance;
  return sum;
}

void Overlay::add_box(const Box& box, glm::vec4 colour) { quads_.push_back({box, {}, colour}); }

void Overlay::add_text(float left, float top, std::string_view text, glm::vec4 colour) {
  float x = left;
  float y = top + ascent_;
  while (!text.empty()) {
    stbtt_aligned_quad quad{};
    stbtt_GetPackedQuad(font_->glyphs.data(), atlas_width, atlas_height, font_->glyph(next_character(text)),
                        &x, &y, &quad, 0);
    quads_.push_back({{quad.x0, quad.y0, quad.x1, quad.y1}, {quad.s0, quad.t0, quad.s1, quad.t1}, colour});
  }
}

void Overlay::draw() {
  if (quads_.empty()) return;
  program_.use();
  glViewport(0, 0, static_cast<GLsizei>(picture_.x), static_cast<GLsizei>(picture_.y));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(quads_.size() * sizeof(Quad)), quads_.data(),
               GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(quads_.size()));
  quads_.clear();
}

}  // namespace sluice::draw
