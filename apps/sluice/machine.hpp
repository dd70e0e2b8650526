// Where a run computes and draws: the backend that was asked for, or that suits the machine, and the OpenGL
// context, made only when something needs it.
#pragma once

#include <memory>
#include <string>

#include "apps/sluice/options.hpp"
#include "core/solver/backend.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"

namespace sluice::app {

/// Factor on the memory of the fields that a run may take: a software OpenGL copies some.
double memory_factor(const MachineOptions& options);

/// The options of a machine that is to compute on the GPU beside the CPU.
MachineOptions on_gpu(MachineOptions options);

/// The CPU backend that the options ask for.
std::unique_ptr<Backend> make_cpu_backend(const MachineOptions& options);

class Machine {
 public:
  /// Machine for a run of `particles` fluid particles. InputError for a choice that contradicts itself,
  /// EnvironmentError when --backend gpu finds no OpenGL. With `shown`, the context of a window that outlives
  /// this, it computes and draws there.
  Machine(const MachineOptions& options, uint64_t particles, const gpu::Context* shown = nullptr);

  Backend& backend() { return *backend_; }
  const gpu::GpuBackend* gpu_backend() const { return gpu_backend_; }  ///< null on the CPU
  const gpu::Context& context();
  /// Text that says what was chosen and why, for people.
  const std::string& choice() const { return choice_; }

 private:
  void choose(uint64_t particles);
  void use_cpu(const std::string& why);
  void use_gpu(const std::string& why);

  MachineOptions options_;
  gpu::ShaderLibrary shaders_;
  std::unique_ptr<gpu::Context> own_context_;  // outlives the backend
  const gpu::Context* context_;
  std::unique_ptr<Backend> backend_;
  const gpu::GpuBackend* gpu_backend_ = nullptr;
  std::string choice_;
};

}  // namespace sluice::app
