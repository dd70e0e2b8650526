// A compute shader linked into a program, checked against the tables, and its dispatch.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/gl_object.hpp"
#include "gpu/shader.hpp"

namespace sluice::gpu {

/// Numbers of groups in x and y; more than the driver allows in one dimension are spread over two.
struct Groups {
  uint32_t x = 0, y = 1;
};
Groups spread(uint64_t groups, uint32_t most_per_dimension);

class ComputeProgram {
 public:
  /// Storage block that the shader uses, bound by its place among them.
  struct StorageBlock {
    std::string name;
    uint32_t members = 0;  ///< number of members; an array is one
    uint32_t type = 0;     ///< type of the last member: OpenGL's, as GL_FLOAT_VEC2
    uint32_t stride = 0;   ///< stride of the last member: bytes from one element of its array to the next
  };
  struct UniformMember {
    std::string block;  ///< empty for a uniform by itself
    std::string name;   ///< name without that of the block
    uint32_t type;      ///< OpenGL's, as GL_FLOAT_VEC2
    uint32_t offset;
  };

  /// Compiles and links `source`; errors as those of Shader.
  ComputeProgram(const Context& context, const ShaderSource& source);

  /// Invocations per group, as the shader declares them.
  uint32_t group_size() const { return group_size_; }
  const std::string& title() const { return title_; }
  const std::vector<StorageBlock>& storage() const { return storage_; }
  /// Images that the shader reads, bound by their place among them.
  const std::vector<std::string>& images() const { return images_; }
  /// Uniforms that the shader uses, in blocks or not.
  const std::vector<UniformMember>& uniforms() const { return uniforms_; }

  /// Lets the uniform block of this name read what is bound to `binding`; does nothing when there is none.
  void bind_uniform_block(const std::string& block, uint32_t binding);

  /// Sets a uniform by itself; does nothing when the shader does not use it.
  void set(const std::string& uniform, uint32_t value);
  void set(const std::string& uniform, double value);
  void set(const std::string& uniform, glm::dvec2 value);

  /// Binds a buffer to the storage block of this name; does nothing when the shader does not use it.
  void bind(std::string_view block, const Buffer& buffer) const;

  /// Runs the program with what is bound, and makes what it wrote visible to all that follows.
  void dispatch(Groups groups) const;
  /// Runs it as dispatch() does, with the numbers of groups read from the three uints from byte `offset` of
  /// `groups` on.
  void dispatch_indirect(const Buffer& groups, uint32_t offset) const;

 private:
  void read_interface();

  std::string title_;
  ProgramObject program_;
  uint32_t group_size_ = 0;
  std::vector<StorageBlock> storage_;
  std::vector<std::string> images_;
  std::vector<UniformMember> uniforms_;
  std::map<std::string, int> locations_;
};

}  // namespace sluice::gpu
