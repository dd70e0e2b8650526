// The contract between shaders and tables.
#include "gpu/stage_program.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "gpu/context.hpp"

namespace sluice::gpu {
namespace {

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

ShaderSource stage_source(const ShaderLibrary& shaders, Stage stage, const Needs& needs, const Pass& pass,
                          uint32_t group_size, Loads loads) {
  const std::string name = std::string(info(stage).name) + ".comp";
  std::string start = prelude(stage, pass.number, group_size, loads);
  const std::string text = shaders.load(name).text;
  for (const NeedInfo& row : need_table) {
    const std::string constant = fmt::format("needs_{}", row.name);
    if (text.find(constant) != std::string::npos)
      start += fmt::format("const bool {} = {};\n", constant, needs.*row.need);
  }
  return shaders.load(name, start, epilogue(pass.entry));
}

std::string stage_listing(const ShaderLibrary& shaders, Stage stage, const Needs& needs) {
  constexpr uint32_t group_size = 64;
  // So many chunks that a reduction has all its kinds of passes, each of which is listed once.
  const std::vector<Pass> passes = passes_of(stage, {.fluid = 2 * chunk_width * chunk_width}, group_size);
  std::string text;
  for (size_t k = 0; k < passes.size(); ++k) {
    if (k > 0 && passes[k].number == passes[k - 1].number) continue;
    text += fmt::format("// ---- {}, pass {}\n", info(stage).name, passes[k].number) +
            with_places(stage_source(shaders, stage, needs, passes[k], group_size, Loads::blocks));
  }
  return text;
}

StageProgram::StageProgram(const Context& context, Stage stage, const ShaderSource& source)
    : program_(context, source), overridden_(source.overridden) {
  for (uint32_t k = 0; k < uniform_blocks().size(); ++k)
    program_.bind_uniform_block(std::string(uniform_blocks()[k].name), k);
  check_storage(stage);
  check_images(stage);
  check_uniforms();
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

void StageProgram::check_uniforms() const {
  for (const ComputeProgram::UniformMember& found : program_.uniforms()) {
    const auto block = std::ranges::find(uniform_blocks(), found.block, &UniformBlock::name);
    if (block == uniform_blocks().end()) {
      refuse(fmt::format("has the uniform {}{}, expected constants in the blocks that it is given only",
                         found.name, found.block.empty() ? "" : " in " + found.block));
    }
    const auto known = std::ranges::find(block->members, found.name, &UniformMember::name);
    if (known != block->members.end() && known->offset == found.offset && gl_type(known->type) == found.type)
      continue;
    refuse(
        fmt::format("the uniform {} does not have the type and place that the table gives it", found.name));
  }
}

}  // namespace sluice::gpu
