// How many steps a run has and how long they are.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

/// Runs breaking_dam (dt 0.04; 0.01 with ssph) and checks steps, time and the rows of the series.
void expect_steps(const Words& more, size_t steps, double dt) {
  const TemporaryFolder folder;
  Words words{"run",     "breaking_dam", "--precision", "double",    "--threads",   "1",
              "--quiet", "--series",     "series.csv",  "--summary", "summary.json"};
  words.insert(words.end(), more.begin(), more.end());
  std::string line;
  for (const std::string& word : more) line += word + ' ';
  const ProgramResult result = run_program(words, folder.path);
  ASSERT_EQ(result.code, 0) << line << result.err;
  const auto summary = read_json(folder / "summary.json");
  EXPECT_EQ(summary["steps"], steps) << line;
  EXPECT_DOUBLE_EQ(summary["time"].get<double>(), static_cast<double>(steps) * dt) << line;
  const Table series = read_table(folder / "series.csv");
  ASSERT_EQ(series.size(), steps) << line;
  for (size_t row = 0; row < steps; ++row) {
    EXPECT_EQ(series.text(row, "step"), std::to_string(row + 1)) << line;
    EXPECT_DOUBLE_EQ(series.at(row, "time"), static_cast<double>(row + 1) * dt) << line;
    EXPECT_EQ(series.at(row, "dt"), dt) << line;
  }
}

TEST(CliSteps, AreTheTimeOverTheTimeStepRounded) {
  expect_steps({"--time", "0.2"}, 5, 0.04);
  expect_steps({"--time", "0.21"}, 5, 0.04);  // no short last step
  expect_steps({"--time", "0.23"}, 6, 0.04);
  expect_steps({"--time", "0.01"}, 0, 0.04);
  expect_steps({"--time", "0"}, 0, 0.04);
  expect_steps({"--set", "time.duration=0.3"}, 8, 0.04);  // 7.5
  expect_steps({"--time", "0.12", "--set", "time.duration=0.4"}, 3, 0.04);
}

TEST(CliSteps, CanBeGiven) {
  expect_steps({"--steps", "7"}, 7, 0.04);
  expect_steps({"--steps", "0"}, 0, 0.04);
  expect_steps({"--steps", "3", "--set", "time.duration=0.04"}, 3, 0.04);
}

TEST(CliSteps, AMethodHasItsOwnTimeStep) {
  expect_steps({"--time", "0.2", "--set", "pressure.method=ssph"}, 20, 0.01);
  expect_steps({"--time", "0.2", "--set", "pressure.method=ssph", "--set", "time.dt=0.005"}, 40, 0.005);
  expect_steps({"--time", "0.2", "--set", "time.dt=0.005", "--set", "pressure.method=ssph"}, 40, 0.005);
  expect_steps({"--time", "0.2", "--set", "pressure.ssph.dt=0.008", "--set", "pressure.method=ssph"}, 25,
               0.008);
  expect_steps({"--time", "0.2", "--set", "pressure.ssph.dt=0.008"}, 5, 0.04);
  expect_steps({"--time", "0.2", "--set", "time.dt=0.01", "--set", "time.dt=0.02"}, 10, 0.02);
}

}  // namespace
}  // namespace sluice::test
