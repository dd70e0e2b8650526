// The window of `sluice play`: what is the same for scenes, recordings and the list of scenes. It moves the
// camera, changes colours and the overlay, takes screenshots, and keeps the pace.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/sluice/options.hpp"
#include "apps/sluice/play/pace.hpp"
#include "draw/painter.hpp"
#include "gpu/context.hpp"
#include "media/window.hpp"

namespace sluice::app {

class Viewer {
 public:
  /// Opens the window. Errors as those of Window and of gpu::Context.
  Viewer(glm::uvec2 size, OverlayChoice overlay, const std::optional<std::filesystem::path>& shader_dir);

  const gpu::Context& context() const { return context_; }
  OverlayChoice overlay() const { return overlay_; }
  bool over() const { return over_ || window_.closed(); }

  /// Sets what is shown from now on, in a window of this size; `help` says what its own keys do.
  void begin(glm::uvec2 size, Colour colour, std::vector<std::string> help);
  void set_title(const std::string& title);

  /// Waits until the next picture is due, or, when `idle`, until the user does something. Returns what the
  /// user did and the viewer doesn't answer itself.
  std::vector<media::WindowEvent> turn(bool idle);
  /// Whether the picture has changed through the user.
  bool changed() const { return changed_; }
  /// Whether there is time to compute before the next picture.
  bool time_left() const { return Clock::now() < deadline_; }

  /// Tells the user a line, in the picture until the next key and on standard error.
  void say(const std::string& message);

  /// Shows the picture that `paint` makes of `labels`, which have the text; as a screenshot it is called
  /// `name`.
  void show(draw::Painter& painter, draw::Frame labels, const std::string& name,
            const std::function<void(draw::Frame)>& paint);

  /// Size of the window, and its showing, for pictures made of several, which are placed by Renderer::show.
  glm::uvec2 size() const { return window_.size(); }
  void present();

 private:
  bool answers(const media::WindowEvent& event);
  bool answers_character(char32_t typed);
  void zoom(glm::dvec2 about, double factor);
  void save_screenshot(const draw::Renderer& renderer, const std::string& name);

  media::Window window_;
  gpu::Context context_;
  OverlayChoice overlay_;
  Colour colour_ = Colour::speed;
  draw::Camera camera_;
  std::vector<std::string> help_;
  std::string message_;
  bool shows_help_ = false, wants_screenshot_ = false, over_ = false, changed_ = true, drags_bar_ = false;
  std::optional<draw::Box> timeline_;  // of the last picture
  Clock::time_point next_ = Clock::now(), deadline_ = next_;
};

}  // namespace sluice::app
