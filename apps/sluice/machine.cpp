// The choice of the backend.
#include "apps/sluice/machine.hpp"

#include <fmt/format.h>

#include "cpu/backend.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

/// Particles from which on `auto` looks for a graphics card: with fewer, a step is over on the CPU before a
/// card has taken all that it is told to do.
constexpr uint64_t worth_a_card = 20'000;

}  // namespace

double memory_factor(const MachineOptions& options) {
  return options.backend == BackendChoice::gpu ? 1.5 : 1;
}

MachineOptions on_gpu(MachineOptions options) {
  options.backend = BackendChoice::gpu;
  options.instructions.reset();
  return options;
}

std::unique_ptr<Backend> make_cpu_backend(const MachineOptions& options) {
  return cpu::make_backend(options.precision, options.threads,
                           options.instructions.value_or(cpu::widest_instructions()));
}

Machine::Machine(const MachineOptions& options, uint64_t particles, const gpu::Context* shown)
    : options_(options), shaders_(options.shader_dir), context_(shown) {
  choose(particles);
}

void Machine::choose(uint64_t particles) {
  const bool in_double = options_.precision == Precision::double_;
  if (options_.backend == BackendChoice::gpu && in_double) {
    throw InputError(
        "--precision double: found it with --backend gpu, expected --backend cpu; the GPU computes in float");
  }
  if (options_.backend == BackendChoice::gpu && options_.instructions) {
    throw InputError(fmt::format(
        "--instructions {}: found it with --backend gpu, expected --backend cpu; they are the CPU's",
        name_of(*options_.instructions)));
  }
  if (options_.backend == BackendChoice::cpu) return use_cpu("as asked for");
  if (options_.backend == BackendChoice::gpu) {
    if (context_ == nullptr) gpu::suit_software_threads(particles);
    context();
    return use_gpu("as asked for");
  }
  if (in_double) return use_cpu("double runs there");
  if (options_.instructions) return use_cpu("--instructions are for it");
  if (particles < worth_a_card) {
    return use_cpu(fmt::format("below about {} particles it is the faster one", worth_a_card));
  }
  try {
    context();
  } catch (const EnvironmentError& error) {
    const std::string what = error.what();
    return use_cpu(what.substr(0, what.find('\n')));
  }
  if (context_->software()) return use_cpu("OpenGL is drawn by the processor: " + context_->renderer());
  use_gpu("a graphics card");
}

const gpu::Context& Machine::context() {
  if (context_ == nullptr) {
    own_context_ = std::make_unique<gpu::Context>(options_.gl_device, shaders_);
    context_ = own_context_.get();
  }
  return *context_;
}

void Machine::use_cpu(const std::string& why) {
  backend_ = make_cpu_backend(options_);
  choice_ = fmt::format("cpu, {} threads ({})", options_.threads, why);
}

void Machine::use_gpu(const std::string& why) {
  auto made = gpu::make_backend(*context_, {.timed = options_.time_stages});
  gpu_backend_ = made.get();
  backend_ = std::move(made);
  choice_ = fmt::format("gpu, {} ({})", context_->renderer(), why);
}

}  // namespace sluice::app
