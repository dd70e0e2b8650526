// Owners of OpenGL objects. An object is made and destroyed while its context is current; whoever holds
// objects beyond one function keeps the Context too and makes it current first.
#pragma once

#include <cstdint>
#include <utility>

namespace sluice::gpu {

class Context;

enum class ObjectKind { buffer, vertex_array, texture, framebuffer, renderbuffer, program };

/// Makes the context current and creates an object in it; EnvironmentError when the driver has no more.
uint32_t create_object(const Context& context, ObjectKind kind);
void delete_object(ObjectKind kind, uint32_t name) noexcept;

/// One OpenGL object of its kind, deleted at the end of the owner's life. Its number is for use inside gpu/
/// only.
template <ObjectKind kind>
class Object {
 public:
  explicit Object(const Context& context) : name_(create_object(context, kind)) {}
  ~Object() {
    if (name_ != 0) delete_object(kind, name_);
  }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  uint32_t name() const { return name_; }

 private:
  uint32_t name_ = 0;
};

using Buffer = Object<ObjectKind::buffer>;
using VertexArray = Object<ObjectKind::vertex_array>;
using Texture = Object<ObjectKind::texture>;
using Framebuffer = Object<ObjectKind::framebuffer>;
using Renderbuffer = Object<ObjectKind::renderbuffer>;
using ProgramObject = Object<ObjectKind::program>;

}  // namespace sluice::gpu
