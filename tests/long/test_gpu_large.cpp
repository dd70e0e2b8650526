// Large scenes on the GPU backend: 74,000 and a million particles, whose fields go beyond the size of a
// storage block that OpenGL promises. On llvmpipe their states are the CPU's, byte for byte.
#include <gtest/gtest.h>

#include "gpu/context.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

std::string state_of(const std::string& backend, const std::vector<std::string>& settings,
                     const std::string& steps, int& fluid) {
  const TemporaryFolder folder;
  std::vector<std::string> words{"run",      "breaking_dam", "--backend", backend,   "--precision",
                                 "float",    "--steps",      steps,       "--quiet", "--summary",
                                 "sum.json", "--state",      "state.csv"};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  const ProgramResult result = run_program(words, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  const auto summary = read_json(folder / "sum.json");
  fluid = summary["fluid"];
  EXPECT_EQ(summary["backend"], backend);
  EXPECT_GT(summary["iterations_mean"], 1);
  EXPECT_LT(summary["compression_max"], 0.05);
  return read_file(folder / "state.csv");
}

void expect_same_states(const std::vector<std::string>& settings, const std::string& steps, int at_least) {
  int fluid = 0;
  const std::string gpu = state_of("gpu", settings, steps, fluid);
  EXPECT_GE(fluid, at_least);
  if (gpu::Context().software()) {
    EXPECT_TRUE(gpu == state_of("cpu", settings, steps, fluid)) << "the states differ";
  }
}

TEST(LargeGpuRun, SeventyFourThousandParticles) {
  expect_same_states({"particles.spacing=0.8", "viscosity.coefficient=2", "time.dt=0.004"}, "50", 74'000);
}

TEST(LargeGpuRun, AMillionParticles) {
  expect_same_states({"particles.spacing=0.2187", "viscosity.coefficient=0.3", "time.dt=0.001"}, "5",
                     1'000'000);
}

}  // namespace
}  // namespace sluice::test
