// The shaders of all stages as files, for compilers to look at.
#pragma once

#include <string>
#include <vector>

#include "gpu/passes.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

/// The passes of a stage, each number once.
std::vector<gpu::Pass> passes_of(Stage stage);

/// Writes every text that a stage can have, for each pass, each combination of models, blocks and images, to
/// a file STAGE_NUMBER.comp, and returns how many there are.
int write_all_stages(const TemporaryFolder& folder);

/// Compiles every FILE.comp in the folder to FILE.comp.spv; returns what the compiler says against one of
/// them.
std::string compile_to_spirv(const TemporaryFolder& folder);

}  // namespace sluice::test
