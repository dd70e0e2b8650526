// Takes the place of all other files in builds without OpenGL.
#include "gpu/backend.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/context.hpp"
#include "gpu/stage_program.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {
namespace {

[[noreturn]] void refuse() {
  throw EnvironmentError(
      "this program was built without OpenGL; run scripts/setup and build it again with -DSLUICE_GPU=ON");
}

}  // namespace

struct Context::State {};

Context::Context(std::optional<int>, ShaderLibrary) { refuse(); }
Context::Context(std::function<void()>, ShaderLibrary) { refuse(); }
Context::~Context() = default;
const std::string& Context::renderer() const { refuse(); }
bool Context::software() const { return true; }

ShaderLibrary::ShaderLibrary(std::optional<std::filesystem::path> folder) {
  if (folder) refuse();
}

std::vector<DeviceInfo> list_devices() { refuse(); }
std::string describe(const std::vector<DeviceInfo>&) { return {}; }
void suit_software_threads(uint64_t) {}
std::unique_ptr<GpuBackend> make_backend(const Context&, const BackendOptions&) { refuse(); }
std::string stage_listing(const ShaderLibrary&, Stage, const Needs&) { refuse(); }
double copy_seconds(const Context&, uint64_t, int) { refuse(); }
void delete_object(ObjectKind, uint32_t) noexcept {}

}  // namespace sluice::gpu
