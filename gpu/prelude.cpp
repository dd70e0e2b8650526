// Tables -> GLSL.
#include "gpu/prelude.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iterator>

#include "sluice/choices.hpp"

namespace sluice::gpu {
namespace {

std::string_view glsl_type(Type type) {
  switch (type) {
    case Type::real: return "float";
    case Type::vec2: return "vec2";
    case Type::vec4: return "vec4";
    case Type::uint: return "uint";
    case Type::uvec2: return "uvec2";
  }
  return "";
}

std::string constants(uint32_t pass, uint32_t group_size) {
  std::string text = fmt::format("#define PASS {}\n", pass);
  const auto add = [&](std::string_view name, uint32_t value) {
    text += fmt::format("const uint {} = {}u;\n", name, value);
  };
  const auto add_choices = [&](std::string_view what, const ChoiceTable& choices) {
    for (uint32_t i = 0; i < choices.rows.size(); ++i)
      add(fmt::format("{}_{}", what, choices.rows[i].identifier), choices.first + i);
  };
  add("group_size", group_size);
  add("slice_width", slice_width);
  add("chunk_width", chunk_width);
  add("scan_width", scan_width);
  add("list_beyond_bounds", list_beyond_bounds);
  add("most_rounds", most_rounds);
  for (const auto& [name, kind] :
       {std::pair("particles", SweepGroups::particles), std::pair("chunks", SweepGroups::chunks),
        std::pair("update", SweepGroups::update), std::pair("test", SweepGroups::test)})
    add(fmt::format("groups_of_{}", name), 3 * static_cast<uint32_t>(kind));
  add("solve_unfinished", static_cast<uint32_t>(Solve::unfinished));
  add("solve_converged", static_cast<uint32_t>(Solve::converged));
  add("solve_capped", static_cast<uint32_t>(Solve::capped));
  for (uint32_t total = 0; total < total_count; ++total)
    add("total_" + std::string(total_names[total]), total);
  add("total_count", total_count);
  add("first_max_total", first_max_total);
  for (uint32_t sum = 0; sum < residual_sum_count; ++sum)
    add("residual_" + std::string(residual_sum_names[sum]), sum);
  add_choices("solver", choices_of(Solver{}));
  add_choices("stop", choices_of(Stop{}));
  return text;
}

std::string uniforms() {
  std::string text;
  for (const UniformBlock& block : uniform_blocks()) {
    text += fmt::format("layout(std140) uniform {} {{\n", block.name);
    for (const UniformMember& member : block.members)
      text += fmt::format("  {} {};  // {}\n", glsl_type(member.type), member.name, member.meaning);
    text += &block == &uniform_blocks().front() ? "} params;\n" : "};\n";
  }
  return text;
}

std::string storage(std::string_view block, std::string_view access, std::string_view type,
                    std::string_view name) {
  return fmt::format("layout(std430) restrict {}buffer {} {{ {} {}[]; }};\n", access, block, type, name);
}

std::string loader(Field field, Loads loads) {
  const std::string_view name = info(field).name;
  if (loads == Loads::blocks) return fmt::format("#define load_{0}(i) {0}[i]\n", name);
  const std::string texels = texels_name(field);
  const uint32_t components = element_bytes(info(field).type, 4) / 4;
  std::string value;
  for (uint32_t k = 0; k < components; ++k) {
    const std::string at = components == 1 ? "i" : fmt::format("{}u * (i) + {}u", components, k);
    value += fmt::format("{}imageLoad({}, int({})).x", k == 0 ? "" : ", ", texels, at);
  }
  const bool real = !is_integer(field);
  return fmt::format("layout({}) uniform readonly restrict {} {};\n#define load_{}(i) {}({})\n",
                     real ? "r32f" : "r32ui", real ? "imageBuffer" : "uimageBuffer", texels, name,
                     glsl_type(info(field).type), value);
}

std::string fields(Stage stage, Loads loads) {
  std::string text;
  for (uint32_t i = 0; i < field_count; ++i) {
    const Field field = static_cast<Field>(i);
    const bool reads = info(stage).reads.has(field), writes = info(stage).writes.has(field);
    if (!reads && !writes) continue;
    text += fmt::format("// {} [{}]\n", info(field).meaning, info(field).unit);
    text +=
        storage(block_name(field), writes ? "" : "readonly ", glsl_type(info(field).type), info(field).name);
    text += loader(field, writes ? Loads::blocks : loads);
  }
  return text;
}

}  // namespace

std::string texels_name(Field field) { return std::string(info(field).name) + "_texels"; }
std::string block_name(Field field) { return std::string(info(field).name) + "_block"; }

const std::array<UniformBlock, 2>& uniform_blocks() {
  static const std::array<UniformBlock, 2> blocks = [] {
    std::array<UniformBlock, 2> made{{{"params_block", {}}, {"pass_block", {}}}};
    uint32_t end = 0;
    const auto add = [&](UniformBlock& block, const char* name, Type type, const char* meaning) {
      const uint32_t bytes = element_bytes(type, 4);
      const uint32_t offset = block.members.empty() ? 0 : (end + bytes - 1) / bytes * bytes;
      block.members.push_back({name, type, offset, meaning});
      end = offset + bytes;
    };
    auto& [params, pass] = made;
#define REAL(name, value, meaning) add(params, #name, Type::real, meaning);
#define VEC2(name, value, meaning) add(params, #name, Type::vec2, meaning);
#define UINT(name, value, meaning) add(params, #name, Type::uint, meaning);
    SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT
#define CONSTANT(name, meaning) add(pass, #name, Type::uint, meaning);
    SLUICE_PASS_CONSTANTS(CONSTANT)
#undef CONSTANT
    return made;
  }();
  return blocks;
}

std::vector<std::byte> params_bytes(const Params& params) {
  const ParamsOf<float> values = params.to<float>();
  const std::vector<UniformMember>& layout = uniform_blocks()[0].members;
  const UniformMember& last = layout.back();
  const uint32_t size = last.offset + element_bytes(last.type, 4);
  std::vector<std::byte> bytes((size + 15) / 16 * 16);
  auto member = layout.begin();
  const auto put = [&](const auto& value) {
    static_assert(sizeof(value) == 4 || sizeof(value) == 8);
    std::memcpy(bytes.data() + (member++)->offset, &value, sizeof(value));
  };
#define REAL(name, value, meaning) put(values.name);
#define VEC2(name, value, meaning) put(values.name);
#define UINT(name, value, meaning) put(values.name);
  SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT
  return bytes;
}

std::string prelude(Stage stage, uint32_t pass, uint32_t group_size, Loads loads) {
  std::string text = "#version 430 core\n";
  text += fmt::format("layout(local_size_x = {}) in;\n", group_size);
  text += constants(pass, group_size);
  text += uniforms();
  text += fields(stage, loads);
  text += "#define load(field, i) load_##field(i)\n";
  if (has_scratch(stage)) text += storage(scratch_block, "", "uint", "scratch");
  if (ends_sweeps(stage)) text += storage(sweep_groups_block, "", "uint", "sweep_groups");
  return text;
}

std::string_view epilogue(Entry entry) {
  switch (entry) {
    case Entry::invocation:
      return R"(
void main() {
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint i = group * group_size + gl_LocalInvocationIndex;
  if (i < count) run(i);
}
)";
    case Entry::group:
      return R"(
void main() { run_group(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x); }
)";
  }
  return "";
}

}  // namespace sluice::gpu
