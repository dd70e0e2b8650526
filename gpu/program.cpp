// Compiling and linking, with the driver's log in the error.
#include "gpu/program.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "gpu/context.hpp"
#include "gpu/embedded.hpp"

namespace sluice::gpu {
namespace {

// A shader object is needed only until its program is linked.
class Shader {
 public:
  Shader(GLenum stage, const ShaderSource& source) : name_(glCreateShader(stage)) {
    const GLchar* text = source.text.data();
    const GLint length = static_cast<GLint>(source.text.size());
    glShaderSource(name_, 1, &text, &length);
    glCompileShader(name_);
    GLint done = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return;
    GLint size = 0;
    glGetShaderiv(name_, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<size_t>(size > 0 ? size : 1), '\0');
    glGetShaderInfoLog(name_, size, &size, log.data());
    log.resize(static_cast<size_t>(size));
    glDeleteShader(name_);
    throw Error(fmt::format("{} does not compile:\n{}", source.name, log));
  }
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

void link(GLuint program, const std::string& title) {
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done == GL_TRUE) return;
  GLint size = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<size_t>(size > 0 ? size : 1), '\0');
  glGetProgramInfoLog(program, size, &size, log.data());
  log.resize(static_cast<size_t>(size));
  throw Error(fmt::format("{} do not link:\n{}", title, log));
}

}  // namespace

ShaderSource embedded_shader(std::string_view name) {
  const std::string_view text = embedded_file(name);
  if (text.empty()) throw Error(fmt::format("{}: no such shader in this program; build it again", name));
  return {std::string(name), std::string(text)};
}

Program::Program(const Context& context, const ShaderSource& vertex, const ShaderSource& fragment)
    : title_(fmt::format("{} and {}", vertex.name, fragment.name)), program_(context) {
  const Shader vertex_shader(GL_VERTEX_SHADER, vertex);
  const Shader fragment_shader(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(program_.name(), vertex_shader.name());
  glAttachShader(program_.name(), fragment_shader.name());
  link(program_.name(), title_);
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

}  // namespace sluice::gpu
