// The programs of a stage: one per pass, each checked against the stage table and the layout of the fields.
#pragma once

#include <optional>
#include <vector>

#include "core/model/params.hpp"
#include "core/model/stages.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/passes.hpp"
#include "gpu/prelude.hpp"

namespace sluice::gpu {

/// Block of a stage's shader: a field's, or one of the two that are none.
struct BoundBlock {
  enum class What { field, scratch, sweep_groups } what = What::field;
  Field field = Field::count;
};

/// Text of one pass of a stage, whole. Needs that it asks for are constants, needs_NAME; scenes that differ
/// in others have the same text.
ShaderSource stage_source(const ShaderLibrary& shaders, Stage stage, const Needs& needs, const Pass& pass,
                          uint32_t group_size, Loads loads);

/// Text of every pass of a stage, for people: as it is compiled where shaders read from blocks, in groups of
/// 64.
std::string stage_listing(const ShaderLibrary& shaders, Stage stage, const Needs& needs);

class StageProgram {
 public:
  /// Compiles and links a pass, and checks it. Error, for overridden shaders InputError, when the shader's
  /// blocks, types, strides or offsets are not those of the tables.
  StageProgram(const Context& context, Stage stage, const ShaderSource& source);

  const ComputeProgram& program() const { return program_; }
  /// Blocks of the shader, in the order of their bindings.
  const std::vector<BoundBlock>& blocks() const { return blocks_; }
  /// Fields read as images, by unit.
  const std::vector<Field>& images() const { return images_; }

 private:
  void check_storage(Stage stage);
  void check_images(Stage stage);
  void check_uniforms() const;
  [[noreturn]] void refuse(const std::string& what) const;

  ComputeProgram program_;
  bool overridden_;
  std::vector<BoundBlock> blocks_;
  std::vector<Field> images_;
};

}  // namespace sluice::gpu
