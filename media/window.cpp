// Window over GLFW. The library is loaded when a window is opened, so that a program that only computes needs
// neither it nor a display.
#include "media/window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sluice/error.hpp"

namespace sluice::media {
namespace {

#define SLUICE_GLFW(FUNCTION)            \
  FUNCTION(glfwInit)                     \
  FUNCTION(glfwTerminate)                \
  FUNCTION(glfwGetError)                 \
  FUNCTION(glfwWindowHint)               \
  FUNCTION(glfwCreateWindow)             \
  FUNCTION(glfwDestroyWindow)            \
  FUNCTION(glfwMakeContextCurrent)       \
  FUNCTION(glfwGetCurrentContext)        \
  FUNCTION(glfwSwapBuffers)              \
  FUNCTION(glfwSwapInterval)             \
  FUNCTION(glfwWaitEventsTimeout)        \
  FUNCTION(glfwPollEvents)               \
  FUNCTION(glfwWindowShouldClose)        \
  FUNCTION(glfwSetWindowTitle)           \
  FUNCTION(glfwSetWindowUserPointer)     \
  FUNCTION(glfwGetWindowUserPointer)     \
  FUNCTION(glfwGetFramebufferSize)       \
  FUNCTION(glfwGetWindowSize)            \
  FUNCTION(glfwSetWindowSize)            \
  FUNCTION(glfwGetPrimaryMonitor)        \
  FUNCTION(glfwGetMonitorWorkarea)       \
  FUNCTION(glfwGetCursorPos)             \
  FUNCTION(glfwSetKeyCallback)           \
  FUNCTION(glfwSetCharCallback)          \
  FUNCTION(glfwSetMouseButtonCallback)   \
  FUNCTION(glfwSetCursorPosCallback)     \
  FUNCTION(glfwSetScrollCallback)        \
  FUNCTION(glfwSetWindowRefreshCallback) \
  FUNCTION(glfwSetFramebufferSizeCallback)

/// The functions of GLFW that are used, from the library of the machine.
struct Glfw {
#define FUNCTION(name) decltype(&::name) name = nullptr;
  SLUICE_GLFW(FUNCTION)
#undef FUNCTION
  void* library = nullptr;

  Glfw() {
    library = dlopen("libglfw.so.3", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
      throw EnvironmentError(
          "a window needs libglfw.so.3, which cannot be loaded; install the package libglfw3");
#define FUNCTION(name) name = find<decltype(name)>(#name);
    SLUICE_GLFW(FUNCTION)
#undef FUNCTION
  }

  std::string error() const {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason is given";
  }

 private:
  template <class Pointer>
  Pointer find(const char* name) {
    void* found = dlsym(library, name);
    if (found == nullptr)
      throw EnvironmentError(
          fmt::format("libglfw.so.3 lacks {}; install a libglfw3 of version 3.3 or later", name));
    return reinterpret_cast<Pointer>(found);
  }
};

/// Loaded when first asked for, and kept: GLFW calls back with nothing but a window.
const Glfw& glfw() {
  static const Glfw loaded;
  return loaded;
}

Key key_of(int code) {
  switch (code) {
    case GLFW_KEY_LEFT: return Key::left;
    case GLFW_KEY_RIGHT: return Key::right;
    case GLFW_KEY_UP: return Key::up;
    case GLFW_KEY_DOWN: return Key::down;
    case GLFW_KEY_HOME: return Key::home;
    case GLFW_KEY_END: return Key::end;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return Key::enter;
    case GLFW_KEY_ESCAPE: return Key::escape;
    default: return Key::none;
  }
}

}  // namespace

struct Window::State {
  GLFWwindow* window = nullptr;
  std::vector<WindowEvent> events;
  bool held = false;  // the left mouse button
  glm::dvec2 pointer{};

  State() {
    if (glfw().glfwInit() == GLFW_FALSE) {
      throw EnvironmentError(fmt::format(
          "a window needs a display: {}; run this where there is one, or make a film with `sluice run SCENE "
          "--video FILE.mp4`",
          glfw().error()));
    }
  }
  ~State() {
    if (window != nullptr) glfw().glfwDestroyWindow(window);
    glfw().glfwTerminate();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  static State& of(GLFWwindow* window);
  void open(glm::uvec2 size, const std::string& title);
  void listen();
  static glm::ivec2 within_screen(glm::uvec2 size);
  void resize(glm::uvec2 size);
  void add(WindowEvent event) {
    event.at = pointer;
    events.push_back(event);
  }
  glm::uvec2 pixels() const;
  glm::dvec2 place(double x, double y) const;
  void on_pointer(double x, double y);
};

Window::State& Window::State::of(GLFWwindow* window) {
  return *static_cast<State*>(glfw().glfwGetWindowUserPointer(window));
}

// EGL first, as without a window; the platform's own way where a driver has no EGL for windows.
void Window::State::open(glm::uvec2 size, const std::string& title) {
  const glm::ivec2 fitting = within_screen(size);
  glfw().glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfw().glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfw().glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfw().glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  glfw().glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfw().glfwWindowHint(GLFW_STENCIL_BITS, 0);
  for (const int api : {GLFW_EGL_CONTEXT_API, GLFW_NATIVE_CONTEXT_API}) {
    glfw().glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
    window = glfw().glfwCreateWindow(fitting.x, fitting.y, title.c_str(), nullptr, nullptr);
    if (window != nullptr) break;
  }
  if (window == nullptr) {
    throw EnvironmentError(fmt::format(
        "no window with OpenGL 4.3: {}; install a newer graphics driver, or libegl1, libopengl0 and "
        "libgl1-mesa-dri to draw on the processor",
        glfw().error()));
  }
  resize(size);
}

/// Size of the window: as large as asked for, or smaller in the same proportions.
glm::ivec2 Window::State::within_screen(glm::uvec2 size) {
  glm::ivec2 room(size), corner;
  if (GLFWmonitor* monitor = glfw().glfwGetPrimaryMonitor(); monitor != nullptr)
    glfw().glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &room.x, &room.y);
  const glm::dvec2 share = glm::dvec2(room) / glm::dvec2(size);
  return glm::max(glm::ivec2(glm::dvec2(size) * std::min({1.0, share.x, share.y})), 1);
}

/// GLFW counts in the screen's own units, of which a pixel may be a part.
void Window::State::resize(glm::uvec2 size) {
  glm::ivec2 units;
  glfw().glfwGetWindowSize(window, &units.x, &units.y);
  const glm::dvec2 units_per_pixel = glm::dvec2(units) / glm::dvec2(pixels());
  const glm::ivec2 wanted(glm::round(glm::dvec2(within_screen(size)) * units_per_pixel));
  if (wanted != units) glfw().glfwSetWindowSize(window, wanted.x, wanted.y);
}

void Window::State::listen() {
  glfw().glfwSetWindowUserPointer(window, this);
  glfw().glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int, int action, int) {
    const Key key = key_of(code);
    if (action != GLFW_RELEASE && key != Key::none) of(w).add({.kind = WindowEvent::key, .pressed = key});
  });
  glfw().glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    of(w).add({.kind = WindowEvent::character, .typed = character});
  });
  glfw().glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    State& state = of(w);
    state.held = action == GLFW_PRESS;
    state.add({.kind = state.held ? WindowEvent::press : WindowEvent::release});
  });
  glfw().glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).on_pointer(x, y); });
  glfw().glfwSetScrollCallback(window, [](GLFWwindow* w, double, double clicks) {
    of(w).add({.kind = WindowEvent::wheel, .clicks = clicks});
  });
  glfw().glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).add({}); });
  glfw().glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).add({}); });
}

void Window::State::on_pointer(double x, double y) {
  const glm::dvec2 before = std::exchange(pointer, place(x, y));
  if (held) add({.kind = WindowEvent::drag, .moved = pointer - before});
}

glm::uvec2 Window::State::pixels() const {
  glm::ivec2 size;
  glfw().glfwGetFramebufferSize(window, &size.x, &size.y);
  return glm::uvec2(glm::max(size, 1));
}

/// Pointers are told in the screen's own units, of which a pixel may be a part.
glm::dvec2 Window::State::place(double x, double y) const {
  glm::ivec2 units;
  glfw().glfwGetWindowSize(window, &units.x, &units.y);
  return glm::dvec2(x, y) * glm::dvec2(pixels()) / glm::dvec2(glm::max(units, 1));
}

Window::Window(glm::uvec2 size, const std::string& title) : state_(std::make_unique<State>()) {
  state_->open(size, title);
  state_->listen();
  make_current();
  glfw().glfwSwapInterval(1);
  // From here on the pointer is where events say: asked for later, it would be ahead of them.
  double x = 0, y = 0;
  glfw().glfwGetCursorPos(state_->window, &x, &y);
  state_->pointer = state_->place(x, y);
}

Window::~Window() = default;

void Window::make_current() const {
  if (glfw().glfwGetCurrentContext() != state_->window) glfw().glfwMakeContextCurrent(state_->window);
}

void Window::set_title(const std::string& title) { glfw().glfwSetWindowTitle(state_->window, title.c_str()); }

glm::uvec2 Window::size() const { return state_->pixels(); }

void Window::resize(glm::uvec2 size) { state_->resize(size); }

std::vector<WindowEvent> Window::events(double seconds) {
  if (seconds > 0) {
    glfw().glfwWaitEventsTimeout(seconds);
  } else {
    glfw().glfwPollEvents();
  }
  return std::exchange(state_->events, {});
}

bool Window::closed() const { return glfw().glfwWindowShouldClose(state_->window) == GLFW_TRUE; }

void Window::present() { glfw().glfwSwapBuffers(state_->window); }

}  // namespace sluice::media
