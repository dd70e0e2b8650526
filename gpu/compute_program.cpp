// Linking, reflection, dispatch and barrier.
#include "gpu/compute_program.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace sluice::gpu {
namespace {

std::string resource_name(GLuint program, GLenum kind, GLuint index) {
  std::array<GLchar, 256> text{};
  GLsizei length = 0;
  glGetProgramResourceName(program, kind, index, static_cast<GLsizei>(text.size()), &length, text.data());
  return {text.data(), static_cast<size_t>(length)};
}

GLuint resource_count(GLuint program, GLenum kind) {
  GLint count = 0;
  glGetProgramInterfaceiv(program, kind, GL_ACTIVE_RESOURCES, &count);
  return static_cast<GLuint>(count);
}

template <size_t n>
std::array<GLint, n> properties(GLuint program, GLenum kind, GLuint index,
                                const std::array<GLenum, n>& names) {
  std::array<GLint, n> values{};
  glGetProgramResourceiv(program, kind, index, static_cast<GLsizei>(n), names.data(), static_cast<GLsizei>(n),
                         nullptr, values.data());
  return values;
}

/// Whatever reads next, from whichever side, sees what was written.
void make_visible() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                  GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace

Groups spread(uint64_t groups, uint32_t most_per_dimension) {
  if (groups <= most_per_dimension) return {static_cast<uint32_t>(groups), 1};
  const uint64_t rows = (groups + most_per_dimension - 1) / most_per_dimension;
  return {static_cast<uint32_t>((groups + rows - 1) / rows), static_cast<uint32_t>(rows)};
}

ComputeProgram::ComputeProgram(const Context& context, const ShaderSource& source)
    : title_(source.name), program_(context) {
  const Shader shader(GL_COMPUTE_SHADER, source);
  glAttachShader(program_.name(), shader.name());
  link_program(program_.name(), {&source});
  glDetachShader(program_.name(), shader.name());
  read_interface();
}

void ComputeProgram::read_interface() {
  const GLuint program = program_.name();
  std::array<GLint, 3> local_size{};
  glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, local_size.data());
  group_size_ = static_cast<uint32_t>(local_size[0]);
  for (GLuint block = 0; block < resource_count(program, GL_SHADER_STORAGE_BLOCK); ++block) {
    storage_.push_back({resource_name(program, GL_SHADER_STORAGE_BLOCK, block)});
    glShaderStorageBlockBinding(program, block, block);
  }
  for (GLuint k = 0; k < resource_count(program, GL_BUFFER_VARIABLE); ++k) {
    const auto [index, type, stride] =
        properties<3>(program, GL_BUFFER_VARIABLE, k, {GL_BLOCK_INDEX, GL_TYPE, GL_ARRAY_STRIDE});
    StorageBlock& block = storage_.at(static_cast<size_t>(index));
    ++block.members;
    block.type = static_cast<uint32_t>(type);
    block.stride = static_cast<uint32_t>(stride);
  }
  for (GLuint k = 0; k < resource_count(program, GL_UNIFORM); ++k) {
    const auto [block, type, offset, location] =
        properties<4>(program, GL_UNIFORM, k, {GL_BLOCK_INDEX, GL_TYPE, GL_OFFSET, GL_LOCATION});
    const std::string name = resource_name(program, GL_UNIFORM, k);
    if (type == GL_IMAGE_BUFFER || type == GL_UNSIGNED_INT_IMAGE_BUFFER) {
      glProgramUniform1i(program, location, static_cast<GLint>(images_.size()));
      images_.push_back(name);
    } else if (block < 0) {
      locations_[name] = location;
      uniforms_.push_back({"", name, static_cast<uint32_t>(type), 0});
    } else {
      const std::string block_name = resource_name(program, GL_UNIFORM_BLOCK, static_cast<GLuint>(block)),
                        prefix = block_name + '.';
      uniforms_.push_back({block_name, name.starts_with(prefix) ? name.substr(prefix.size()) : name,
                           static_cast<uint32_t>(type), static_cast<uint32_t>(offset)});
    }
  }
}

void ComputeProgram::bind_uniform_block(const std::string& block, uint32_t binding) {
  const GLuint index = glGetUniformBlockIndex(program_.name(), block.c_str());
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_.name(), index, binding);
}

void ComputeProgram::set(const std::string& uniform, uint32_t value) {
  const auto known = locations_.find(uniform);
  if (known != locations_.end()) glProgramUniform1ui(program_.name(), known->second, value);
}

void ComputeProgram::set(const std::string& uniform, double value) {
  const auto known = locations_.find(uniform);
  if (known != locations_.end()) glProgramUniform1d(program_.name(), known->second, value);
}

void ComputeProgram::set(const std::string& uniform, glm::dvec2 value) {
  const auto known = locations_.find(uniform);
  if (known != locations_.end()) glProgramUniform2d(program_.name(), known->second, value.x, value.y);
}

void ComputeProgram::bind(std::string_view block, const Buffer& buffer) const {
  for (GLuint binding = 0; binding < storage_.size(); ++binding) {
    if (storage_[binding].name == block) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
  }
}

void ComputeProgram::dispatch(Groups groups) const {
  glUseProgram(program_.name());
  glDispatchCompute(groups.x, groups.y, 1);
  make_visible();
}

void ComputeProgram::dispatch_indirect(const Buffer& groups, uint32_t offset) const {
  glUseProgram(program_.name());
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.name());
  glDispatchComputeIndirect(static_cast<GLintptr>(offset));
  make_visible();
}

}  // namespace sluice::gpu
