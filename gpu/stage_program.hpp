// The programs of a stage: one per pass, each checked against the stage table and the layout of the fields.
#pragma once

#include <optional>
#include <vector>

#include "core/model/params.hpp"
#include "core/model/stages.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/prelude.hpp"

namespace sluice::gpu {

/// What a stage does in how many dispatches. `number` is PASS in the shader.
struct Pass {
  uint32_t number = 0;
  Entry entry = Entry::invocation;
  uint64_t count = 0;        ///< invocations, or what `count` means to groups
  uint64_t per_group = 0;    ///< of `count`, how much one group takes
  bool over_chunks = false;  ///< runs over chunks of particles instead of particles
  // Of reductions only: one level of the tree (shaders/lib/fold.glsl).
  uint32_t fold_length = 0, fold_from = 0, fold_to = 0;
  bool fold_first = true;
};

std::vector<Pass> passes_of(Stage stage, const Sizes& sizes, uint32_t group_size);

/// Cells that grid_scan can sum up: one group scans the sums of runs of cells, in loops that some drivers end
/// after so many rounds.
uint64_t most_cells(uint32_t group_size);

/// Elements of scratch memory that the passes of all stages need.
uint64_t scratch_size(const Sizes& sizes);

/// A block of a stage's shader: a field's, or one of the two that are none.
struct BoundBlock {
  enum class What { field, scratch, sweep_groups } what = What::field;
  Field field = Field::count;
};

/// The whole text of one pass of a stage.
ShaderSource stage_source(const ShaderLibrary& shaders, Stage stage, const Needs& needs, const Pass& pass,
                          uint32_t group_size, Loads loads);

class StageProgram {
 public:
  /// Error, for overridden shaders InputError, when the shader's blocks, types, strides or offsets are not
  /// those of the tables.
  StageProgram(const Context& context, Stage stage, const ShaderSource& source);

  ComputeProgram& program() { return program_; }
  /// By binding.
  const std::vector<BoundBlock>& blocks() const { return blocks_; }
  /// Fields read as images, by unit.
  const std::vector<Field>& images() const { return images_; }

 private:
  void check_storage(Stage stage);
  void check_images(Stage stage);
  void check_params() const;
  [[noreturn]] void refuse(const std::string& what) const;

  ComputeProgram program_;
  bool overridden_;
  std::vector<BoundBlock> blocks_;
  std::vector<Field> images_;
};

}  // namespace sluice::gpu
