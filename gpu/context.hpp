// OpenGL 4.3 without a display, through EGL. Nothing of OpenGL is loaded before a Context is made.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/shader.hpp"

namespace sluice::gpu {

/// Description of an EGL device: its renderer, or why it can't be used.
struct DeviceInfo {
  int index = 0;
  bool software = false;                  ///< a processor that plays a graphics card
  std::string renderer;                   ///< GL_RENDERER and the version; empty when unusable
  std::string problem;                    ///< empty when usable
  std::optional<uint64_t> free_memory{};  ///< bytes of its own that are free, where the driver says so
};

/// EGL devices in their own order; the index is what Context takes. No context is current afterwards.
/// EnvironmentError when EGL itself is missing.
std::vector<DeviceInfo> list_devices();

/// Text with a line per device, for messages and for the user.
std::string describe(const std::vector<DeviceInfo>& devices);

/// Tells a driver that computes on the processor to use a single thread when there are fewer than about
/// 20,000 particles, which is faster than handing them over to several; unless LP_NUM_THREADS is set. To be
/// called before the first Context.
void suit_software_threads(uint64_t particles);

/// Throws an EnvironmentError that names the Debian package when the shared library can't be loaded.
void require_library(const char* library, const char* package);

/// Words that the environment variable SLUICE_GL may hold, for those who look for faults, separated by
/// commas: `debug` lets drivers check every call and say what they find, which is slow; `hardware` takes a
/// processor that plays a graphics card for one, so that what is done on cards only can be tried without.
bool environment_says(std::string_view word);

/// An OpenGL core context of version 4.3 or later, current after construction. Objects made from it keep a
/// reference: it outlives them and stays where it is.
class Context {
 public:
  /// Tries hardware devices, software devices, the surfaceless platform and the default display, in this
  /// order, or only the EGL device given. InputError when there is no such device; EnvironmentError, with
  /// what was tried and what to install, when there is no OpenGL. `shaders` is where programs made from it
  /// come from.
  explicit Context(std::optional<int> device = std::nullopt, ShaderLibrary shaders = ShaderLibrary());

  /// Takes part in a context that somebody else made and keeps, such as a window's; `make_current` makes it
  /// so. EnvironmentError when it is older than 4.3.
  Context(std::function<void()> make_current, ShaderLibrary shaders);
  ~Context();
  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;

  /// Binds the context to the calling thread.
  void make_current() const;

  /// Throws what OpenGL has complained about since the last check: EnvironmentError when it ran out of
  /// memory, else Error. `during` says what was being done.
  void check(std::string_view during) const;

  const std::string& renderer() const;
  const std::string& vendor() const;
  const std::string& version() const;
  bool software() const;  ///< drawn by the processor
  /// Bytes of a card's own memory that are free, where its driver says so.
  std::optional<uint64_t> free_memory() const;
  const ShaderLibrary& shaders() const;

 private:
  friend std::vector<DeviceInfo> list_devices();
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sluice::gpu
