// Simulations on a graphics card, by OpenGL 4.3 without a display, in float.
#pragma once

#include <filesystem>
#include <optional>

#include "sluice/simulation.hpp"

namespace sluice::gpu {

struct DeviceOptions {
  std::optional<int> gl_device{};  ///< number in `sluice info`; the first that can be used if not given
  std::optional<std::filesystem::path> shader_dir{};  ///< a folder with shaders in place of the library's own
  /// Particles that there will be, about: where a processor plays the card, it does better with one thread
  /// for few.
  uint64_t particles = 0;
};

/// A graphics card, or a processor that plays one. EnvironmentError when there is no OpenGL 4.3, InputError
/// when there is no such device.
Device device(const DeviceOptions& options = {});

}  // namespace sluice::gpu
