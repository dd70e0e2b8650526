// Takes the place of all other files in builds without OpenGL. Nothing here is reached: a picture needs a
// context, and there is none.
#include "draw/image.hpp"
#include "draw/painter.hpp"
#include "gpu/context.hpp"

namespace sluice::draw {

struct Renderer::State {};

Renderer::~Renderer() = default;
void Renderer::look(glm::uvec2, const Camera&) {}
Image Renderer::read() const { return {}; }
void Renderer::show(glm::uvec2, uint32_t) const {}
const Panels& Renderer::panels() const {
  static const Panels none;
  return none;
}

Renderer::Renderer(const gpu::Context&, glm::uvec2, Vec2, Vec2, double, ParticleShape) {}
DeviceFluid::~DeviceFluid() = default;
Painter::Painter(const gpu::Context& context, Outliving<Scene> scene, Outliving<Samples> samples,
                 glm::uvec2 size)
    : context_(context), scene_(scene), samples_(samples), renderer_(context, size, {}, {}, 0) {}
void Painter::paint(Frame, double, const Snapshot&) {}
void Painter::paint(Frame, double, const gpu::GpuBackend&) {}

std::string encode_png(const Image&) { return {}; }
PngWriter::PngWriter(size_t queue_limit) : queue_limit_(queue_limit) {}
PngWriter::~PngWriter() = default;
void PngWriter::write(std::filesystem::path, Image) {}
void PngWriter::flush() {}
void PngWriter::finish() {}

}  // namespace sluice::draw
