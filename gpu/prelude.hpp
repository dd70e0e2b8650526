// What every stage's shader begins and ends with, made from the tables that the C++ side uses: constants, the
// uniform block of parameters, a storage block per field the stage reads or writes, and main(). So a shader
// cannot touch a field that the stage table does not give it, nor see another layout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/params.hpp"
#include "core/model/stages.hpp"

namespace sluice::gpu {

/// Meaning of one invocation of a pass: `run(i)` is called for all i < count, or `run_group(group)` by all
/// invocations of a group.
enum class Entry { invocation, group };

/// Number of consecutive cells that one invocation of the prefix sum takes.
inline constexpr uint32_t scan_width = 64;

/// Way in which `load(field, i)` reads a field that the stage does not write: from its storage block, or as a
/// texel of an image of the buffer. On graphics cards the first is the fast way; llvmpipe reads a block's
/// elements one by one, with a branch for each, and texels together, about five times as fast.
enum class Loads { blocks, texels };

std::string prelude(Stage stage, uint32_t pass, uint32_t group_size, Loads loads);
std::string_view epilogue(Entry entry);

/// Whether the stage has scratch memory, and whether it writes how many groups the stages after it have; both
/// as gpu/passes.cpp says.
bool has_scratch(Stage stage);
bool ends_sweeps(Stage stage);

/// Name of the field's block in GLSL: "x_block"; the array in it has the field's name.
std::string block_name(Field field);
/// Name of the field as an image: "x_texels".
std::string texels_name(Field field);
/// Numbers of groups in each dimension that stages of a sweep have: those over particles, those over chunks,
/// and the update, which runs once more when the solve is over.
enum class SweepGroups : uint32_t { particles, chunks, update, count };

/// Storage blocks that are no fields: memory for the passes of one stage, and the numbers of groups of the
/// sweeps to come, as SweepGroups.
inline constexpr std::string_view scratch_block = "scratch_block", sweep_groups_block = "sweep_groups_block";

/// Place of a parameter in the uniform block "params_block", by the rules of std140.
struct ParamsMember {
  std::string name;
  Type type;
  uint32_t offset;
  std::string_view meaning;
};
const std::vector<ParamsMember>& params_layout();
std::vector<std::byte> params_bytes(const Params& params);

}  // namespace sluice::gpu
