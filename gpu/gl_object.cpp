// Creation and deletion of OpenGL objects by kind.
#include "gpu/gl_object.hpp"

#include <epoxy/gl.h>

#include <type_traits>

#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {

static_assert(std::is_same_v<GLuint, uint32_t>);

uint32_t create_object(const Context& context, ObjectKind kind) {
  context.make_current();
  GLuint name = 0;
  switch (kind) {
    case ObjectKind::buffer: glGenBuffers(1, &name); break;
    case ObjectKind::vertex_array: glGenVertexArrays(1, &name); break;
    case ObjectKind::texture: glGenTextures(1, &name); break;
    case ObjectKind::framebuffer: glGenFramebuffers(1, &name); break;
    case ObjectKind::renderbuffer: glGenRenderbuffers(1, &name); break;
    case ObjectKind::program: name = glCreateProgram(); break;
  }
  if (name == 0) throw EnvironmentError("OpenGL cannot create another object; graphics memory may be full");
  return name;
}

void delete_object(ObjectKind kind, uint32_t name) noexcept {
  switch (kind) {
    case ObjectKind::buffer: return glDeleteBuffers(1, &name);
    case ObjectKind::vertex_array: return glDeleteVertexArrays(1, &name);
    case ObjectKind::texture: return glDeleteTextures(1, &name);
    case ObjectKind::framebuffer: return glDeleteFramebuffers(1, &name);
    case ObjectKind::renderbuffer: return glDeleteRenderbuffers(1, &name);
    case ObjectKind::program: return glDeleteProgram(name);
  }
}

}  // namespace sluice::gpu
