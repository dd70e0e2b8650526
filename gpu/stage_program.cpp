// Passes by stage, and the contract between shaders and tables.
#include "gpu/stage_program.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "gpu/context.hpp"

namespace sluice::gpu {
namespace {

uint64_t groups_of(uint64_t count, uint64_t per_group) { return (count + per_group - 1) / per_group; }

Pass each_invocation(uint32_t number, uint64_t count, uint32_t group_size) {
  Pass pass;
  pass.number = number;
  pass.count = count;
  pass.per_group = group_size;
  return pass;
}

Pass each_chunk(uint32_t number, const Sizes& sizes, uint32_t group_size) {
  Pass pass = each_invocation(number, sizes.chunks(), group_size);
  pass.over_chunks = true;
  return pass;
}

Pass one_group(uint32_t number, uint64_t count) {
  Pass pass;
  pass.number = number;
  pass.entry = Entry::group;
  pass.count = count;
  pass.per_group = count;
  return pass;
}

/// `arrays` folds of `length` values each, level by level, the last one by `last_count` invocations.
std::vector<Pass> fold_passes(uint64_t length, uint64_t arrays, uint64_t last_count, uint32_t group_size) {
  std::vector<Pass> passes;
  uint64_t from = 0, to = 0;
  const uint64_t half = arrays * groups_of(length, chunk_width);  // two halves of scratch, used in turns
  const auto add = [&](Pass pass) {
    pass.fold_length = static_cast<uint32_t>(length);
    pass.fold_from = static_cast<uint32_t>(from);
    pass.fold_to = static_cast<uint32_t>(to);
    pass.fold_first = passes.empty();
    passes.push_back(pass);
  };
  while (length > chunk_width) {
    add(each_invocation(0, arrays * groups_of(length, chunk_width), group_size));
    length = groups_of(length, chunk_width);
    from = to;
    to = half - to;
  }
  add(each_invocation(1, last_count, group_size));
  return passes;
}

uint32_t gl_type(Type type) {
  switch (type) {
    case Type::real: return GL_FLOAT;
    case Type::vec2: return GL_FLOAT_VEC2;
    case Type::vec4: return GL_FLOAT_VEC4;
    case Type::uint: return GL_UNSIGNED_INT;
    case Type::uvec2: return GL_UNSIGNED_INT_VEC2;
  }
  return GL_NONE;
}

/// The field that `name_of` calls `name`; Field::count if none.
Field field_named(const std::string& name, std::string (*name_of)(Field)) {
  for (uint32_t i = 0; i < field_count; ++i) {
    if (name_of(static_cast<Field>(i)) == name) return static_cast<Field>(i);
  }
  return Field::count;
}

}  // namespace

std::vector<Pass> passes_of(Stage stage, const Sizes& sizes, uint32_t group_size) {
  const uint64_t n = sizes.fluid, cells = sizes.of(Length::cells);
  switch (stage) {
    case Stage::grid_count: return {each_invocation(0, cells, group_size), each_invocation(1, n, group_size)};
    case Stage::grid_scan: {
      const uint64_t runs = groups_of(cells, scan_width);
      return {each_invocation(0, runs, group_size), one_group(1, runs), each_invocation(2, runs, group_size)};
    }
    case Stage::grid_order: return {each_invocation(0, n, group_size), each_invocation(1, n, group_size)};
    case Stage::neighbours:
      return {each_invocation(0, n, group_size), each_invocation(1, groups_of(n, slice_width), group_size),
              each_invocation(2, n, group_size)};
    case Stage::residual:
    case Stage::diagnostics: return {each_chunk(0, sizes, group_size)};
    case Stage::stop_test: return fold_passes(sizes.chunks(), residual_sum_count, 1, group_size);
    case Stage::totals: return fold_passes(sizes.chunks(), total_count, total_count, group_size);
    default: return {each_invocation(0, sizes.of(info(stage).range), group_size)};
  }
}

uint64_t most_cells(uint32_t group_size) {
  const uint64_t runs_per_invocation = (most_rounds - group_size) / 2;  // it walks over them twice
  return runs_per_invocation * group_size * scan_width - 1;
}

uint64_t scratch_size(const Sizes& sizes) {
  const uint64_t scan = groups_of(sizes.of(Length::cells), scan_width);
  const uint64_t folds = 2 * total_count * groups_of(sizes.chunks(), chunk_width);
  return std::max({sizes.fluid, scan, folds, uint64_t{1}});
}

ShaderSource stage_source(const ShaderLibrary& shaders, Stage stage, const Needs& needs, const Pass& pass,
                          uint32_t group_size, Loads loads) {
  return shaders.load(std::string(info(stage).name) + ".comp",
                      prelude(stage, needs, pass.number, group_size, loads), epilogue(pass.entry));
}

StageProgram::StageProgram(const Context& context, Stage stage, const ShaderSource& source)
    : program_(context, source), overridden_(source.overridden) {
  check_storage(stage);
  check_images(stage);
  check_params();
}

void StageProgram::refuse(const std::string& what) const {
  refuse_shader(overridden_, program_.title() + ": " + what);
}

void StageProgram::check_storage(Stage stage) {
  for (const ComputeProgram::StorageBlock& block : program_.storage()) {
    const Field field = field_named(block.name, block_name);
    BoundBlock bound{BoundBlock::What::field, field};
    if (block.name == scratch_block) bound.what = BoundBlock::What::scratch;
    if (block.name == sweep_groups_block) bound.what = BoundBlock::What::sweep_groups;
    const bool is_field = bound.what == BoundBlock::What::field;
    if (is_field && (field == Field::count || !(info(stage).reads | info(stage).writes).has(field)))
      refuse(
          fmt::format("has the storage block {}, which the stage's row in the table does not", block.name));
    const Type type = is_field ? info(field).type : Type::uint;
    if (block.members != 1 || block.type != gl_type(type)) {
      refuse(fmt::format("the storage block {} is not one array of the type that the table gives it",
                         block.name));
    }
    if (block.stride != element_bytes(type, 4)) {
      refuse(fmt::format("an element of {} has {} bytes, expected {}", block.name, block.stride,
                         element_bytes(type, 4)));
    }
    blocks_.push_back(bound);
  }
}

void StageProgram::check_images(Stage stage) {
  for (const std::string& image : program_.images()) {
    const Field field = field_named(image, texels_name);
    if (field == Field::count || !info(stage).reads.has(field) || info(stage).writes.has(field))
      refuse(fmt::format("reads the image {}, which the stage's row in the table does not give it", image));
    images_.push_back(field);
  }
}

void StageProgram::check_params() const {
  for (const ComputeProgram::UniformMember& member : program_.params()) {
    const auto& layout = params_layout();
    const auto known = std::find_if(layout.begin(), layout.end(),
                                    [&](const ParamsMember& row) { return row.name == member.name; });
    if (known != layout.end() && known->offset == member.offset && gl_type(known->type) == member.type)
      continue;
    refuse(fmt::format("the parameter {} does not have the type and place that the table gives it",
                       member.name));
  }
}

}  // namespace sluice::gpu
