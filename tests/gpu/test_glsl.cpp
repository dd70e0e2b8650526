// Every shader of a stage is GLSL by Khronos's reference compiler: each pass, each combination of models,
// read from blocks and from images. Mesa accepts more than other drivers do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "core/output/output_file.hpp"
#include "gpu/stage_program.hpp"
#include "tests/support/models.hpp"
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
  std::set<std::string> seen;
  int count = 0;
  for (uint32_t s = 0; s < stage_count; ++s) {
    const Stage stage = static_cast<Stage>(s);
    for (const gpu::Pass& pass : passes_of(stage)) {
      for (const Model& model : all_models()) {
        for (const gpu::Loads loads : {gpu::Loads::blocks, gpu::Loads::texels}) {
          const std::string text = gpu::stage_source(shaders, stage, needs_of(model), pass, 64, loads).text;
          if (!seen.insert(text).second) continue;
          write_file(folder / (std::string(info(stage).name) + '_' + std::to_string(count++) + ".comp"),
                     text);
        }
      }
    }
  }
  EXPECT_GT(count, 2 * static_cast<int>(stage_count)) << "some stages have several passes, or ask for needs";
  EXPECT_EQ(complaints(folder), "");
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
