// The search for an OpenGL context through EGL, and the collection of OpenGL's error messages.
#include "gpu/context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "core/text.hpp"
#include "gpu/egl_search.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {
namespace {

constexpr const char* install_hint =
    "install a newer graphics driver, or libegl1, libopengl0 and libgl1-mesa-dri to draw on the processor";

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

/// Free memory of the device whose context is current, where its driver says so.
std::optional<uint64_t> free_memory_of_current() {
  constexpr GLenum available_nvx = 0x9049, free_ati = 0x87fb;  // of GL_NVX_gpu_memory_info and GL_ATI_meminfo
  std::array<GLint, 4> kilobytes{};
  if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
    glGetIntegerv(available_nvx, kilobytes.data());
  else if (epoxy_has_gl_extension("GL_ATI_meminfo"))
    glGetIntegerv(free_ati, kilobytes.data());
  if (kilobytes[0] <= 0) return std::nullopt;
  return uint64_t{1024} * static_cast<uint64_t>(kilobytes[0]);
}

}  // namespace

bool environment_says(std::string_view word) {
  const char* value = std::getenv("SLUICE_GL");
  bool found = false;
  for (std::string_view rest = value != nullptr ? value : ""; !rest.empty();) {
    const size_t end = std::min(rest.find(','), rest.size());
    const std::string_view one = rest.substr(0, end);
    if (one != "debug" && one != "hardware") {
      throw InputError(
          fmt::format("the environment variable SLUICE_GL: found \"{}\", expected debug or hardware, or both "
                      "with a comma",
                      value));
    }
    found = found || one == word;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return found;
}

struct Context::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  // The display is not terminated: it belongs to the whole process, and another Context may be using it.
  ~State() {
    if (make_current) {
      make_current();
      glDebugMessageCallback(nullptr, nullptr);
    }
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context)
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }

  // An exception must not cross the driver's C frames, so messages wait here for check().
  static void EPOXY_CALLSPEC on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                                        const GLchar* text, const void* state) {
    auto& errors = static_cast<State*>(const_cast<void*>(state))->errors;
    if ((type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) || errors.size() >= 8) return;
    errors.emplace_back(text, length < 0 ? std::string_view(text).size() : static_cast<size_t>(length));
  }

  std::string open(const Candidate& candidate);
  std::string create(const Candidate& candidate);
  std::string accept();

  std::function<void()> make_current;  // of a context that somebody else keeps
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  bool software = false;
  std::string renderer, vendor, version;
  std::vector<std::string> errors;
  ShaderLibrary shaders;
};

// Makes the context on this display; returns what went wrong, or nothing.
std::string Context::State::create(const Candidate& candidate) {
  if (candidate.display == EGL_NO_DISPLAY) return "not there";
  display = candidate.display;
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return "cannot be initialised: " + egl_error();
  for (const char* extension :
       {"EGL_KHR_create_context", "EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
    if (!epoxy_has_egl_extension(display, extension)) return fmt::format("lacks {}", extension);
  }
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return "has OpenGL ES only";
  const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION_KHR,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION_KHR,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                         EGL_CONTEXT_FLAGS_KHR,
                                         environment_says("debug") ? EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : 0,
                                         EGL_NONE};
  context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) return "refuses an OpenGL 4.3 core context: " + egl_error();
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    return "cannot make its context current: " + egl_error();
  }
  return "";
}

std::string Context::State::open(const Candidate& candidate) {
  if (std::string problem = create(candidate); !problem.empty()) return problem;
  software = candidate.software;
  return accept();
}

// Checks the version of the current context, notes the strings, sets the debug callback.
std::string Context::State::accept() {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 43) return fmt::format("gives OpenGL {}.{} where 4.3 is needed", major, minor);
  renderer = gl_string(GL_RENDERER);
  vendor = gl_string(GL_VENDOR);
  version = gl_string(GL_VERSION);
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Microsoft Basic Render"}) {
    software = software || renderer.find(name) != std::string::npos;
  }
  software = software && !environment_says("hardware");
  if (!environment_says("debug")) return "";
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(&State::on_message, this);
  return "";
}

std::vector<DeviceInfo> list_devices() {
  require_libraries();
  std::vector<DeviceInfo> result;
  for (const Candidate& candidate : device_candidates()) {
    DeviceInfo info{static_cast<int>(result.size()), candidate.software, "", "", std::nullopt};
    Context::State state;
    info.problem = state.open(candidate);
    if (info.problem.empty()) {
      info.renderer = fmt::format("{}, OpenGL {}", state.renderer, state.version);
      info.software = state.software;
      if (!state.software) info.free_memory = free_memory_of_current();
    }
    result.push_back(std::move(info));
  }
  return result;
}

std::string describe(const std::vector<DeviceInfo>& devices) {
  if (devices.empty()) return "EGL lists no devices";
  std::string text;
  for (const DeviceInfo& device : devices) {
    text += fmt::format("{}{}: {}{}", text.empty() ? "" : "\n", device.index,
                        device.problem.empty() ? device.renderer : "unusable, " + device.problem,
                        device.software ? " (software)" : "");
    if (device.free_memory)
      text += fmt::format(", {} of memory free", bytes_text(static_cast<double>(*device.free_memory)));
  }
  return text;
}

void suit_software_threads(uint64_t particles) {
  constexpr uint64_t worth_handing_over = 20'000;
  if (particles < worth_handing_over) setenv("LP_NUM_THREADS", "0", 0);
}

Context::Context(std::optional<int> device, ShaderLibrary shaders) {
  require_libraries();
  std::vector<Candidate> candidates;
  if (device) {
    candidates = device_candidates();
    if (*device < 0 || static_cast<size_t>(*device) >= candidates.size()) {
      throw InputError(fmt::format("there is no OpenGL device {}; the devices are\n{}", *device,
                                   describe(list_devices())));
    }
    candidates = {candidates[static_cast<size_t>(*device)]};
  } else {
    candidates = all_candidates();
  }
  std::string tried;
  for (const Candidate& candidate : candidates) {
    state_ = std::make_unique<State>();
    const std::string problem = state_->open(candidate);
    if (problem.empty()) {
      state_->shaders = std::move(shaders);
      return;
    }
    tried += fmt::format("\n  {}: {}", candidate.label, problem);
  }
  throw EnvironmentError(fmt::format("no OpenGL 4.3 was found; {}\ntried{}", install_hint, tried));
}

Context::Context(std::function<void()> make_current, ShaderLibrary shaders)
    : state_(std::make_unique<State>()) {
  make_current();
  state_->make_current = std::move(make_current);
  if (const std::string problem = state_->accept(); !problem.empty())
    throw EnvironmentError(fmt::format("the window {}; {}", problem, install_hint));
  state_->shaders = std::move(shaders);
}

Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

void Context::make_current() const {
  if (state_->make_current) return state_->make_current();
  if (eglGetCurrentContext() == state_->context) return;
  // Which API a thread is bound to is the thread's own state.
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
      eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) == EGL_FALSE) {
    throw EnvironmentError("the OpenGL context cannot be made current: " + egl_error());
  }
}

void Context::check(std::string_view during) const {
  bool out_of_memory = false;
  for (int k = 0; k < 8; ++k) {  // several errors may wait; a lost context reports its own for ever
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    out_of_memory = out_of_memory || error == GL_OUT_OF_MEMORY;
    if (state_->errors.empty()) state_->errors.push_back(fmt::format("error {:#06x}", error));
  }
  if (out_of_memory) {
    state_->errors.clear();
    throw EnvironmentError(
        fmt::format("{}: graphics memory is full; use fewer particles or a smaller picture", during));
  }
  if (state_->errors.empty()) return;
  std::string text = fmt::format("{}: OpenGL reports", during);
  for (const std::string& error : std::exchange(state_->errors, {})) text += "\n  " + error;
  throw Error(text);
}

const std::string& Context::renderer() const { return state_->renderer; }
const std::string& Context::vendor() const { return state_->vendor; }
const std::string& Context::version() const { return state_->version; }
bool Context::software() const { return state_->software; }
std::optional<uint64_t> Context::free_memory() const {
  if (state_->software) return std::nullopt;
  make_current();
  return free_memory_of_current();
}
const ShaderLibrary& Context::shaders() const { return state_->shaders; }

}  // namespace sluice::gpu
