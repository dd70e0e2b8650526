// The GPU backend as a device, with the context that it works in.
#include "sluice/gpu.hpp"

#include "core/agree/agreement.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"

namespace sluice::gpu {
namespace {

struct OwnContext {
  Context context;
  std::unique_ptr<GpuBackend> backend;

  explicit OwnContext(const DeviceOptions& options)
      : context(options.gl_device, ShaderLibrary(options.shader_dir)), backend(make_backend(context)) {}
};

/// A backend that keeps the context it is made in.
class ContextBackend final : private OwnContext, public ForwardingBackend {
 public:
  explicit ContextBackend(const DeviceOptions& options) : OwnContext(options), ForwardingBackend(*backend) {}
  void sweep(const std::vector<Stage>& stages, uint32_t times) override { backend->sweep(stages, times); }
};

}  // namespace

Device device(const DeviceOptions& options) {
  if (options.particles > 0) suit_software_threads(options.particles);
  return Device(std::make_unique<ContextBackend>(options));
}

}  // namespace sluice::gpu
