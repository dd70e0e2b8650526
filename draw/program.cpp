// Linking, and uniforms and attributes by name.
#include "draw/program.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "gpu/context.hpp"
#include "sluice/error.hpp"

namespace sluice::draw {

Program::Program(const gpu::Context& context, const gpu::ShaderSource& vertex,
                 const gpu::ShaderSource& fragment)
    : title_(fmt::format("{} and {}", vertex.name, fragment.name)), program_(context) {
  const gpu::Shader vertex_shader(GL_VERTEX_SHADER, vertex);
  const gpu::Shader fragment_shader(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(program_.name(), vertex_shader.name());
  glAttachShader(program_.name(), fragment_shader.name());
  gpu::link_program(program_.name(), {&vertex, &fragment});
  glDetachShader(program_.name(), vertex_shader.name());
  glDetachShader(program_.name(), fragment_shader.name());
}

void Program::use() const { glUseProgram(program_.name()); }

uint32_t Program::attribute(const std::string& name) const {
  const GLint location = glGetAttribLocation(program_.name(), name.c_str());
  if (location < 0) throw Error(fmt::format("{} have no attribute '{}'", title_, name));
  return static_cast<uint32_t>(location);
}

int Program::location(const std::string& uniform) {
  const auto known = locations_.find(uniform);
  if (known != locations_.end()) return known->second;
  const GLint location = glGetUniformLocation(program_.name(), uniform.c_str());
  if (location < 0) throw Error(fmt::format("{} have no uniform '{}'", title_, uniform));
  return locations_[uniform] = location;
}

void Program::set(const std::string& uniform, bool value) {
  glProgramUniform1i(program_.name(), location(uniform), value ? 1 : 0);
}

void Program::set(const std::string& uniform, int value) {
  glProgramUniform1i(program_.name(), location(uniform), value);
}

void Program::set(const std::string& uniform, float value) {
  glProgramUniform1f(program_.name(), location(uniform), value);
}

void Program::set(const std::string& uniform, glm::vec2 value) {
  glProgramUniform2f(program_.name(), location(uniform), value.x, value.y);
}

void Program::set(const std::string& uniform, glm::vec4 value) {
  glProgramUniform4f(program_.name(), location(uniform), value.x, value.y, value.z, value.w);
}

}  // namespace sluice::draw
