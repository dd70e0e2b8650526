// Every shader of a stage is GLSL by Khronos's reference compiler: each pass, each combination of models,
// read from blocks and from images. Mesa accepts more than other drivers do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/output/output_file.hpp"
#include "gpu/stage_program.hpp"
#include "tests/support/needs.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

/// The passes of a stage, each number once.
std::vector<gpu::Pass> passes_of(Stage stage) {
  const Sizes many_chunks{.fluid = 300'000, .cells = 1000};
  std::vector<gpu::Pass> passes;
  for (const gpu::Pass& pass : gpu::passes_of(stage, many_chunks, 64)) {
    if (passes.empty() || passes.back().number != pass.number) passes.push_back(pass);
  }
  return passes;
}

/// glslangValidator's complaints about all shaders in the folder; nothing when there are none.
std::string complaints(const TemporaryFolder& folder) {
  const std::string log = folder / "log";
  const std::string command = "cd " + folder.path.string() +
                              " && glslangValidator $(ls | grep -E '(comp|vert|frag)$') >" + log + " 2>&1";
  return std::system(command.c_str()) == 0 ? "" : read_file(log);
}

TEST(Glsl, EveryShaderOfEveryStageIsValid) {
  const TemporaryFolder folder;
  const gpu::ShaderLibrary shaders;
  int count = 0;
  for (uint32_t s = 0; s < stage_count; ++s) {
    const Stage stage = static_cast<Stage>(s);
    for (const gpu::Pass& pass : passes_of(stage)) {
      for (const Needs& needs : all_needs()) {
        for (const gpu::Loads loads : {gpu::Loads::blocks, gpu::Loads::texels}) {
          const std::string text = gpu::stage_source(shaders, stage, needs, pass, 64, loads).text;
          write_file(folder / (std::string(info(stage).name) + '_' + std::to_string(count++) + ".comp"),
                     text);
        }
      }
    }
  }
  EXPECT_GT(count, 16 * static_cast<int>(stage_count)) << "some stages have several passes";
  EXPECT_EQ(complaints(folder), "");
}

TEST(Glsl, EveryOtherShaderIsValid) {
  const TemporaryFolder folder;
  const gpu::ShaderLibrary shaders;
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SLUICE_SOURCE_DIR) / "shaders")) {
    const std::string name = entry.path().filename();
    const bool is_stage = std::ranges::any_of(
        stage_table(), [&](const StageInfo& stage) { return name == std::string(stage.name) + ".comp"; });
    if (entry.is_directory() || is_stage) continue;
    write_file(folder / name, shaders.load(name).text);
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
