// Where EGL may find OpenGL: its devices and platforms, in the order in which they are tried.
#pragma once

#include <string>
#include <vector>

namespace sluice::gpu {

/// A display that may give a context; a display is EGL's handle for a device or a platform.
struct Candidate {
  std::string label;
  void* display = nullptr;  ///< null when EGL has none
  bool software = false;
};

/// Throws an EnvironmentError when libEGL or libOpenGL is missing; nothing of EGL may be called before.
void require_libraries();

/// The EGL devices, in EGL's own order; none where EGL can't list them.
std::vector<Candidate> device_candidates();

/// All that may give a context, best first: hardware devices, software devices, the surfaceless platform, the
/// default display.
std::vector<Candidate> all_candidates();

/// The reason of the last failure.
std::string egl_error();

}  // namespace sluice::gpu
