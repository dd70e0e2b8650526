// What every stage's shader begins and ends with, made from the tables that the C++ side uses: constants, the
// uniform block of parameters, a storage block per field the stage reads or writes, and main(). So a shader
// cannot touch a field that the stage table does not give it, nor see another layout.
#pragma once

#include <array>
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
/// the update, which runs once more when the solve is over, and the test that ends it.
enum class SweepGroups : uint32_t { particles, chunks, update, test, count };

/// Storage blocks that are no fields: memory for the passes of one stage, and the numbers of groups of the
/// sweeps to come, as SweepGroups.
inline constexpr std::string_view scratch_block = "scratch_block", sweep_groups_block = "sweep_groups_block";

// Numbers that differ from pass to pass: X(name, meaning). All of them are uint.
#define SLUICE_PASS_CONSTANTS(X)                                        \
  X(count, "what this pass runs over")                                  \
  X(cells, "cells, and the end behind the last one")                    \
  X(list_size, "entries that the neighbour list has room for")          \
  X(fold_length, "of a reduction: values per array at this level")      \
  X(fold_from, "of a reduction: where in scratch they stand")           \
  X(fold_to, "of a reduction: where in scratch the groups' results go") \
  X(fold_first, "of a reduction: not 0 at the first level, which reads the stage's sums")

struct PassConstants {
#define MEMBER(name, meaning) uint32_t name = 0;
  SLUICE_PASS_CONSTANTS(MEMBER)
#undef MEMBER
};

/// Place of a constant in its uniform block, by the rules of std140.
struct UniformMember {
  std::string name;
  Type type;
  uint32_t offset;
  std::string_view meaning;
};

/// The uniform blocks of a stage's shader, bound in this order. There are no uniforms but these: params of
/// the scene, as `params.name`, and constants of the pass, as `name`.
struct UniformBlock {
  std::string_view name;
  std::vector<UniformMember> members;
};
const std::array<UniformBlock, 2>& uniform_blocks();
std::vector<std::byte> params_bytes(const Params& params);

}  // namespace sluice::gpu
