// Texts from the tables, SPIR-V from glslangValidator.
#include "tests/support/all_shaders.hpp"

#include <cstdlib>
#include <set>

#include "core/output/output_file.hpp"
#include "gpu/stage_program.hpp"
#include "tests/support/models.hpp"

namespace sluice::test {

std::vector<gpu::Pass> passes_of(Stage stage) {
  const Sizes many_chunks{.fluid = 300'000, .cells = 1000};
  std::vector<gpu::Pass> passes;
  for (const gpu::Pass& pass : gpu::passes_of(stage, many_chunks, 64)) {
    if (passes.empty() || passes.back().number != pass.number) passes.push_back(pass);
  }
  return passes;
}

int write_all_stages(const TemporaryFolder& folder) {
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
  return count;
}

std::string compile_to_spirv(const TemporaryFolder& folder) {
  const std::string log = folder / "log";
  const std::string command =
      "cd " + folder.path.string() +
      " && for f in *.comp; do glslangValidator -V --amb --aml $f -o $f.spv || exit 1; done >" + log +
      " 2>&1";
  return std::system(command.c_str()) == 0 ? "" : "glslangValidator: " + read_file(log);
}

}  // namespace sluice::test
