// Pictures of a fluid, drawn by OpenGL without a display.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "sluice/report.hpp"
#include "sluice/scene.hpp"

namespace sluice::draw {

/// Picture with three bytes per pixel (red, green, blue), rows without padding, top row first.
struct Image {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgb;
};

}  // namespace sluice::draw

namespace sluice::media {

struct PictureOptions {
  std::optional<glm::uvec2> size{};  ///< pixels; the scene's if not given
  std::optional<Colour> colour{};    ///< the scene's if not given
  bool colour_bar = true;            ///< for density and pressure
};

/// Draws states of one scene.
class Pictures {
 public:
  /// EnvironmentError when there is no OpenGL; InputError for a size below 16 pixels or beyond the driver's
  /// limit.
  explicit Pictures(Scene scene, const PictureOptions& options = {});
  ~Pictures();
  Pictures(Pictures&&) noexcept;
  Pictures& operator=(Pictures&&) noexcept;

  /// Draws a state of a simulation, or of a recording's moment; `dt` is the length of the step that led to
  /// it, which speed is shown in.
  draw::Image draw(const Snapshot& state, double dt);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes a picture as PNG. EnvironmentError when the place can't be written.
void write_png(const std::filesystem::path& path, const draw::Image& image);

}  // namespace sluice::media
