// A window with an OpenGL 4.3 context, and what its user does. GLFW and the display are touched here only,
// and not before a Window is made.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace sluice::media {

/// Keys that write no character.
enum class Key { none, left, right, up, down, home, end, enter, escape };

/// Something that the user did. Places are in pixels from the window's top left corner.
struct WindowEvent {
  enum Kind { key, character, press, drag, release, wheel, redraw };
  Kind kind = redraw;
  Key pressed = Key::none;
  char32_t typed = 0;
  glm::dvec2 at{};     ///< place of the pointer
  glm::dvec2 moved{};  ///< way of the pointer since the last drag
  double clicks = 0;   ///< clicks of the wheel, up is positive
};

class Window {
 public:
  /// Opens a window that shows `size` pixels, or as many as the screen has room for. Its context is current.
  /// EnvironmentError when there is no display, no GLFW, or no OpenGL 4.3, saying what is missing.
  Window(glm::uvec2 size, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void make_current() const;
  void set_title(const std::string& title);
  glm::uvec2 size() const;  ///< in pixels; never 0
  /// Asks for as many pixels, or as many as the screen has room for. Done once events() says so.
  void resize(glm::uvec2 size);

  /// Events since the last call. Waits for something to happen for `seconds` at most.
  std::vector<WindowEvent> events(double seconds);
  /// Whether the user has closed the window.
  bool closed() const;

  /// Shows what was drawn.
  void present();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sluice::media
