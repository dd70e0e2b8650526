// The dispatches of each stage. One table has the stages that take several passes or scratch memory, or that
// end a solve; every other stage is one dispatch over the range of its row in the stage table.
#pragma once

#include <vector>

#include "core/model/stages.hpp"
#include "gpu/prelude.hpp"

namespace sluice::gpu {

/// One dispatch of a stage. `number` is PASS in the shader.
struct Pass {
  uint32_t number = 0;
  Entry entry = Entry::invocation;
  uint64_t count = 0;      ///< invocations, or what `count` means to groups
  uint64_t per_group = 0;  ///< how much of `count` one group takes
  // A level of the tree of a reduction (shaders/lib/fold.glsl), in reductions only:
  uint32_t fold_length = 0, fold_from = 0, fold_to = 0;
  bool fold_first = true;
};

/// Contents of the uniform block of a pass.
PassConstants constants_of(const Pass& pass, const Sizes& sizes);

std::vector<Pass> passes_of(Stage stage, const Sizes& sizes, uint32_t group_size);

/// Number of elements of scratch memory that the passes of all stages need.
uint64_t scratch_size(const Sizes& sizes);

/// Number of cells that grid_scan can sum up: one group scans the sums of runs of cells, in loops that some
/// drivers end after so many rounds.
uint64_t most_cells(uint32_t group_size);

/// Kind of groups that a stage of the sweep runs in.
SweepGroups sweep_groups_of(Stage stage);

}  // namespace sluice::gpu
