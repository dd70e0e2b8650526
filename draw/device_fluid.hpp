// The fluid as a picture draws it, taken from the GPU backend's buffers without leaving the graphics card.
#pragma once

#include "draw/particle_pass.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/storage.hpp"
#include "sluice/scene.hpp"

namespace sluice::gpu {
class GpuBackend;
}

namespace sluice::draw {

class DeviceFluid {
 public:
  explicit DeviceFluid(const gpu::Context& context);
  ~DeviceFluid();
  DeviceFluid(const DeviceFluid&) = delete;
  DeviceFluid& operator=(const DeviceFluid&) = delete;

  /// Takes the state of the backend's `count` particles, as the last step left it. `unit` times the speed,
  /// density or pressure is the value of a particle. The backend is one of the same context.
  void collect(const gpu::GpuBackend& backend, size_t count, Colour colour, double unit);

  /// Particles collected last, in the order of ids.
  const Cloud& cloud() const { return cloud_; }

  /// Largest value of the particles collected last, or 0 if none is above. Waits for the graphics card.
  double largest() const;

 private:
  const gpu::Context& context_;
  gpu::ComputeProgram program_;
  Cloud cloud_;
  gpu::Buffer largest_;
  gpu::ReadBack read_back_;
};

}  // namespace sluice::draw
