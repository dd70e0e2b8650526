// Every shader of a stage is GLSL by Khronos's reference compiler: each pass, each combination of models,
// read from blocks and from images. Mesa accepts more than other drivers do. And what that compiler makes of
// them leaves no driver free to contract operations, which llvmpipe never does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/output/output_file.hpp"
#include "gpu/stage_program.hpp"
#include "tests/support/all_shaders.hpp"
#include "tests/support/spirv.hpp"

namespace sluice::test {
namespace {

/// glslangValidator's complaints about all shaders in the folder; nothing when there are none.
std::string complaints(const TemporaryFolder& folder) {
  const std::string log = folder / "log";
  const std::string command = "cd " + folder.path.string() +
                              " && glslangValidator $(ls | grep -E '(comp|vert|frag)$') >" + log + " 2>&1";
  return std::system(command.c_str()) == 0 ? "" : read_file(log);
}

/// Compiles all shaders in the folder to SPIR-V; what a driver may contract, file by file, or what went
/// wrong.
std::string contractable_in(const TemporaryFolder& folder) {
  if (const std::string said = compile_to_spirv(folder); !said.empty()) return said;
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
    if (entry.path().extension() != ".spv") continue;
    const auto module = instructions_of(read_spirv(entry.path()));
    if (module.empty()) return entry.path().string() + " is empty";
    if (const int found = contractable(module); found > 0)
      text += entry.path().stem().stem().string() + ": " + std::to_string(found) + '\n';
  }
  return text;
}

TEST(Glsl, EveryShaderOfEveryStageIsValid) {
  const TemporaryFolder folder;
  const int count = write_all_stages(folder);
  EXPECT_GT(count, 2 * static_cast<int>(stage_count)) << "some stages have several passes, or ask for needs";
  EXPECT_EQ(complaints(folder), "");
}

TEST(Glsl, NoDriverMayContractWhatAStageComputes) {
  const TemporaryFolder folder;
  write_all_stages(folder);
  EXPECT_EQ(contractable_in(folder), "");
}

TEST(Glsl, AContractionThatIsAllowedIsFound) {
  const TemporaryFolder folder;
  const gpu::Pass pass = passes_of(Stage::integrate).front();
  std::string text =
      gpu::stage_source(gpu::ShaderLibrary(), Stage::integrate, {}, pass, 64, gpu::Loads::blocks).text;
  const std::string word = "precise vec2 x_next";
  text.replace(text.find(word), word.size(), "vec2 x_next");
  write_file(folder / "fused.comp", text);
  EXPECT_EQ(contractable_in(folder), "fused: 2\n") << "a product and a sum";
}

TEST(Glsl, EveryOtherShaderIsValid) {
  const TemporaryFolder folder;
  const gpu::ShaderLibrary shaders;
  int count = 0;
  const std::filesystem::path all = std::filesystem::path(SLUICE_SOURCE_DIR) / "shaders";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(all)) {
    const std::filesystem::path name = entry.path().lexically_relative(all);
    const bool is_stage = name.parent_path().empty(), is_part = name.extension() == ".glsl";
    if (entry.is_directory() || is_stage || is_part) continue;
    write_file(folder / name.filename().string(), shaders.load(name.string()).text);
    ++count;
  }
  EXPECT_GE(count, 6);
  EXPECT_EQ(complaints(folder), "");
}

TEST(Glsl, AMistakeIsFound) {
  const TemporaryFolder folder;
  write_file(folder / "a.comp", "#version 430 core\nvoid main() { int i = 1.0; }\n");
  EXPECT_NE(complaints(folder).find("a.comp"), std::string::npos) << "is glslangValidator there?";
}

}  // namespace
}  // namespace sluice::test
