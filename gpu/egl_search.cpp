// The search through EGL's extensions for devices and platforms.
#include "gpu/egl_search.hpp"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <fmt/format.h>

#include <string_view>
#include <type_traits>

#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {

static_assert(std::is_same_v<EGLDisplay, void*>);

namespace {

// An extension of EGL itself, known before any display is.
bool client_has(const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); }

}  // namespace

void require_library(const char* library, const char* package) {
  void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (handle == nullptr) {
    throw EnvironmentError(
        fmt::format("OpenGL needs {}, which cannot be loaded; install the package {}", library, package));
  }
  dlclose(handle);
}

// libepoxy ends the process when it can't load one of these; so they are tried first.
void require_libraries() {
  require_library("libEGL.so.1", "libegl1");
  require_library("libOpenGL.so.0", "libopengl0");
}

std::string egl_error() {
  switch (const EGLint error = eglGetError()) {
    case EGL_SUCCESS: return "no reason given";
    case EGL_NOT_INITIALIZED: return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS: return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC: return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE: return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG: return "EGL_BAD_CONFIG";
    case EGL_BAD_MATCH: return "EGL_BAD_MATCH, the version is not offered";
    default: return fmt::format("EGL error {:#06x}", error);
  }
}

std::vector<Candidate> device_candidates() {
  std::vector<Candidate> result;
  const bool can_list = client_has("EGL_EXT_device_base") || client_has("EGL_EXT_device_enumeration");
  if (!can_list || !client_has("EGL_EXT_platform_device")) return result;
  EGLint count = 0;
  if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE || count <= 0) return result;
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
  if (eglQueryDevicesEXT(count, devices.data(), &count) == EGL_FALSE) return result;
  devices.resize(static_cast<size_t>(count));
  for (const EGLDeviceEXT device : devices) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    const bool software =
        extensions != nullptr &&
        std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
    result.push_back({fmt::format("EGL device {}", result.size()),
                      eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr), software});
  }
  return result;
}

std::vector<Candidate> all_candidates() {
  std::vector<Candidate> result;
  const std::vector<Candidate> devices = device_candidates();
  for (const bool software : {false, true}) {
    for (const Candidate& device : devices) {
      if (device.software == software) result.push_back(device);
    }
  }
  if (client_has("EGL_MESA_platform_surfaceless")) {
    result.push_back({"the surfaceless platform",
                      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                      false});
  }
  result.push_back({"the default display", eglGetDisplay(EGL_DEFAULT_DISPLAY), false});
  return result;
}

}  // namespace sluice::gpu
