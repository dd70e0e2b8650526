// The fluid as a picture draws it, taken from the GPU backend's buffers without leaving the graphics card.
#pragma once

#include "core/scene.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/particle_pass.hpp"

namespace sluice::gpu {

class GpuBackend;

class DeviceFluid {
 public:
  explicit DeviceFluid(const Context& context);
  ~DeviceFluid();
  DeviceFluid(const DeviceFluid&) = delete;
  DeviceFluid& operator=(const DeviceFluid&) = delete;

  /// Takes the state of the backend's `count` particles, as the last step left it. `unit` times the speed,
  /// density or pressure is the value of a particle. The backend is one of the same context.
  void collect(const GpuBackend& backend, size_t count, Colour colour, double unit);

  /// What was collected last, in the order of ids.
  const Cloud& cloud() const { return cloud_; }

  /// The largest value of these, or 0 if none is above. Waits for the graphics card.
  double largest() const;

 private:
  const Context& context_;
  ComputeProgram program_;
  Cloud cloud_;
  Buffer largest_;
};

}  // namespace sluice::gpu
