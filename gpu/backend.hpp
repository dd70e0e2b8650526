// The GPU backend: every stage as OpenGL 4.3 compute shaders, in float. On Mesa's llvmpipe its results are
// those of the CPU backend in float, bit for bit.
#pragma once

#include <memory>

#include "core/solver/backend.hpp"
#include "gpu/gl_object.hpp"

namespace sluice::gpu {

class Context;

class GpuBackend : public Backend {
 public:
  /// The buffer that holds `field`, which is allocated.
  virtual const Buffer& buffer(Field field) const = 0;
  /// Whether nothing was written behind the last element of `field`; see BackendOptions::guard.
  virtual bool guard_is_intact(Field field) const = 0;
};

struct BackendOptions {
  uint32_t group_size = 0;   ///< invocations per group, a multiple of 64; 0 for what suits the device
  uint32_t most_groups = 0;  ///< groups per dimension; 0 for the driver's limit
  uint32_t guard = 0;        ///< words of NaN behind each field, to catch writes out of bounds
  uint32_t most_texels = 0;  ///< texels of a buffer read as an image; 0 for the driver's limit
  uint64_t free_bytes = 0;   ///< graphics memory that is free; 0 for what the driver says, if it does
  bool timed = true;         ///< whether seconds are counted, which takes the driver some time of its own
};

/// Backend on the context's device. The context must outlive it.
std::unique_ptr<GpuBackend> make_backend(const Context& context, const BackendOptions& options = {});

}  // namespace sluice::gpu
