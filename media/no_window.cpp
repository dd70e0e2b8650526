// Takes the place of window.cpp in builds without a window.
#include "media/window.hpp"
#include "sluice/error.hpp"

namespace sluice::media {

struct Window::State {};

Window::Window(glm::uvec2, const std::string&) {
  throw EnvironmentError(
      "this program was built without a window; run scripts/setup and build it again with -DSLUICE_GPU=ON "
      "-DSLUICE_WINDOW=ON");
}
Window::~Window() = default;
void Window::make_current() const {}
void Window::set_title(const std::string&) {}
glm::uvec2 Window::size() const { return glm::uvec2(1); }
void Window::resize(glm::uvec2) {}
std::vector<WindowEvent> Window::events(double) { return {}; }
bool Window::closed() const { return true; }
void Window::present() {}

}  // namespace sluice::media
