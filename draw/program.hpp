// A vertex and a fragment shader linked into a program, with its uniforms and attributes by name.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>

#include "gpu/gl_object.hpp"
#include "gpu/shader.hpp"

namespace sluice::draw {

/// Program of a vertex and a fragment shader, compiled and linked. Error with the file name and the driver's
/// log when a shader is wrong, and when a name is asked for that the program does not have.
class Program {
 public:
  Program(const gpu::Context& context, const gpu::ShaderSource& vertex, const gpu::ShaderSource& fragment);

  void use() const;
  uint32_t attribute(const std::string& name) const;

  void set(const std::string& uniform, bool value);
  void set(const std::string& uniform, int value);
  void set(const std::string& uniform, float value);
  void set(const std::string& uniform, glm::vec2 value);
  void set(const std::string& uniform, glm::vec4 value);

 private:
  int location(const std::string& uniform);

  std::string title_;
  gpu::ProgramObject program_;
  std::map<std::string, int> locations_;
};

}  // namespace sluice::draw
