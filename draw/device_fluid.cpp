// Buffers and dispatch; the work is in shaders/draw/draw_order.comp.
#include "draw/device_fluid.hpp"

#include <epoxy/gl.h>

#include "gpu/backend.hpp"
#include "gpu/context.hpp"

namespace sluice::draw {
namespace {

constexpr uint32_t promised_groups = 0xffff;  // per dimension, by every OpenGL

Field field_of(Colour colour) {
  switch (colour) {
    case Colour::speed: return Field::v_in;
    case Colour::density: return Field::rho;
    case Colour::pressure: return Field::p;
  }
  return Field::count;
}

}  // namespace

DeviceFluid::DeviceFluid(const gpu::Context& context)
    : context_(context),
      program_(context, context.shaders().load("draw/draw_order.comp")),
      cloud_(context),
      largest_(context),
      read_back_(context) {
  gpu::make_room(context, largest_, sizeof(uint32_t), "the largest value");
}

DeviceFluid::~DeviceFluid() { context_.make_current(); }

void DeviceFluid::collect(const gpu::GpuBackend& backend, size_t count, Colour colour, double unit) {
  context_.make_current();
  if (cloud_.count != count) {
    gpu::make_room(context_, cloud_.positions, count * sizeof(glm::vec2), "positions to draw");
    gpu::make_room(context_, cloud_.values, count * sizeof(float), "values to draw");
    cloud_.count = count;
  }
  const GLuint nothing = 0;
  glBindBuffer(GL_COPY_WRITE_BUFFER, largest_.name());
  glBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof(nothing), &nothing);

  program_.bind("id_block", backend.buffer(Field::id));
  program_.bind("x_block", backend.buffer(Field::x_in));
  program_.bind("quantity_block", backend.buffer(field_of(colour)));
  program_.bind("position_block", cloud_.positions);
  program_.bind("value_block", cloud_.values);
  program_.bind("largest_block", largest_);
  program_.set("count", static_cast<uint32_t>(count));
  program_.set("of_vectors", colour == Colour::speed ? 1u : 0u);
  program_.set("unit", unit);
  const uint64_t group_size = program_.group_size();
  program_.dispatch(gpu::spread((count + group_size - 1) / group_size, promised_groups));
}

double DeviceFluid::largest() const {
  context_.make_current();
  float largest = 0;
  read_back_.read(largest_, 0, sizeof(largest), &largest);
  return static_cast<double>(largest);
}

}  // namespace sluice::draw
