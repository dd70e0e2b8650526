// The promise of the README: the state files of `--backend cpu --precision float` and `--backend gpu` are the
// same bytes after 1000 steps of every scene, through the impact and the chaos after it; and so are those of
// two GPU runs. On llvmpipe: hardware divides and takes roots in its own way.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gpu/context.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

struct Finished {
  int code = 0;
  std::string state, series, messages;
  nlohmann::ordered_json summary;
};

Finished run(const std::string& backend, const Words& scene, const std::string& steps = "1000") {
  const TemporaryFolder folder;
  Words words{"run"};
  words.insert(words.end(), scene.begin(), scene.end());
  words.insert(words.end(), {"--backend", backend, "--precision", "float", "--steps", steps, "--quiet",
                             "--state", "state.csv", "--series", "series.csv", "--summary", "summary.json"});
  const ProgramResult result = run_program(words, folder.path);
  return {result.code, read_file(folder / "state.csv"), read_file(folder / "series.csv"), result.err,
          read_json(folder / "summary.json")};
}

class StateOf : public testing::TestWithParam<Words> {};

TEST_P(StateOf, IsTheSameBytesOnBothBackends) {
  if (!gpu::Context().software()) GTEST_SKIP() << "holds on llvmpipe only";
  const Finished cpu = run("cpu", GetParam()), gpu = run("gpu", GetParam());
  EXPECT_EQ(cpu.code, 0) << cpu.messages;
  EXPECT_EQ(gpu.code, 0) << gpu.messages;
  EXPECT_EQ(gpu.summary["backend"], "gpu");
  EXPECT_EQ(cpu.summary["backend"], "cpu");
  EXPECT_EQ(gpu.summary["steps"], 1000);
  EXPECT_GT(cpu.summary["cfl_max"], 0.01) << "nothing moved";
  EXPECT_GT(gpu.state.size(), 5'000u);
  EXPECT_TRUE(gpu.state == cpu.state) << "the states differ";
  // Every step's iterations, residual, densities, energies and forces too.
  EXPECT_TRUE(gpu.series == cpu.series) << "the series differ";
}

INSTANTIATE_TEST_SUITE_P(Scenes, StateOf,
                         testing::Values(Words{"breaking_dam"}, Words{"leaking_dam"},
                                         Words{"falling_from_platform"}, Words{"inclined_plane"},
                                         Words{"resting_fluid"}, Words{"wcsph_box"}, Words{"iisph_box"},
                                         Words{"breaking_dam", "--set", "pressure.method=ssph"},
                                         Words{"breaking_dam", "--set", "pressure.method=wcsph"}),
                         [](const auto& row) {
                           const std::string method =
                               row.param.size() > 1 ? row.param[2] : "pressure.method=default";
                           return fmt::format("{}_{}", row.param[0],
                                              method.substr(std::min<size_t>(16, method.size())));
                         });

// Runs that blow up do so in the same step, at the same particle, for the same reason.
class InvalidRunOf : public testing::TestWithParam<Words> {};

TEST_P(InvalidRunOf, EndsAlikeOnBothBackends) {
  if (!gpu::Context().software()) GTEST_SKIP() << "holds on llvmpipe only";
  const Finished cpu = run("cpu", GetParam(), "100"), gpu = run("gpu", GetParam(), "100");
  EXPECT_EQ(cpu.code, 1);
  EXPECT_EQ(gpu.code, 1);
  EXPECT_EQ(gpu.messages, cpu.messages);
  EXPECT_TRUE(gpu.state == cpu.state);
  EXPECT_TRUE(gpu.series == cpu.series);
}

INSTANTIATE_TEST_SUITE_P(Scenes, InvalidRunOf,
                         testing::Values(Words{"breaking_dam", "--set", "pressure.method=ssph", "--set",
                                               "time.dt=0.1"},
                                         Words{"breaking_dam", "--set", "time.dt=5"},
                                         Words{"breaking_dam", "--set", "viscosity.coefficient=1e30"},
                                         Words{"breaking_dam", "--set", "fluid.gravity=[0,-1e35]"},
                                         Words{"breaking_dam", "--set", "pressure.method=ssph", "--set",
                                               "pressure.ssph.stiffness=1e38"}),
                         [](const auto& row) { return "case" + std::to_string(row.index); });

// A software OpenGL with several threads leaves more to chance: who counts first, which slice stands where.
TEST(State, DoesNotDependOnTheThreadsOfASoftwareOpenGl) {
  if (!gpu::Context().software()) GTEST_SKIP() << "hardware has no such threads";
  const Words scene{"breaking_dam", "--set", "fluid.jitter=0.1"};
  const std::string expected = run("cpu", scene, "300").state;
  for (const char* threads : {"1", "2", "4"}) {
    const TemporaryFolder folder;
    const std::string file = folder / "state.csv";
    RunningProgram program({"run", "breaking_dam", "--set", "fluid.jitter=0.1", "--backend", "gpu", "--steps",
                            "300", "--quiet", "--state", file},
                           {.environment = {std::string("LP_NUM_THREADS=") + threads}});
    EXPECT_EQ(program.wait().code, 0);
    EXPECT_TRUE(read_file(file) == expected) << threads << " threads";
  }
}

TEST(State, OfTwoGpuRunsIsTheSameBytes) {
  const Words scene{"breaking_dam", "--set", "fluid.jitter=0.1"};
  EXPECT_TRUE(run("gpu", scene).state == run("gpu", scene).state);
}

}  // namespace
}  // namespace sluice::test
