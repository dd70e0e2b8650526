// `sluice study NAME --quick`, with bounds wide enough for any machine. Seconds are not judged.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

/// The folder of a study that came out as expected.
std::filesystem::path run_quick(const std::string& study, const TemporaryFolder& folder) {
  const ProgramResult result =
      run_program({"study", study, "--quick", "--jobs", "2", "--out", "out"}, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  return folder.path / "out";
}

TEST(QuickStudy, TimestepOfIisphIsLargerAndOnlySsphFallsApart) {
  const TemporaryFolder folder;
  const std::filesystem::path out = run_quick("timestep", folder);
  const Table limits = read_table(out / "timestep_limits.csv");
  std::map<std::string, std::map<double, double>> largest;
  for (size_t row = 0; row < limits.size(); ++row)
    largest[limits.text(row, "method")][limits.at(row, "h")] = limits.at(row, "dt");
  for (const double h : {16.0, 20.0}) {
    EXPECT_GT(largest["IISPH"][h], 0.006 * h);
    EXPECT_LT(largest["IISPH"][h], 0.0125 * h);
    EXPECT_GT(largest["SSPH"][h], 0.0025 * h);
    EXPECT_LT(largest["SSPH"][h], 0.0066 * h);
    EXPECT_LT(largest["SSPH"][h], largest["IISPH"][h]);
  }
  const Table verdicts = read_table(out / "timestep_verdicts.csv");
  int coherence = 0;
  for (size_t row = 0; row < verdicts.size(); ++row) {
    if (!verdicts.text(row, "claim").starts_with("section 6.2")) continue;
    ++coherence;
    EXPECT_EQ(verdicts.text(row, "verdict"), "holds") << verdicts.text(row, "claim");
  }
  EXPECT_EQ(coherence, 3);
}

TEST(QuickStudy, DensityOscillatesLessTheStifferAndLeastWithIisph) {
  const TemporaryFolder folder;
  const std::filesystem::path out = run_quick("density", folder);
  const Table verdicts = read_table(out / "density_verdicts.csv");
  EXPECT_EQ(verdicts.size(), 3u);
  for (size_t row = 0; row < verdicts.size(); ++row) EXPECT_EQ(verdicts.text(row, "verdict"), "holds");
  const Table windows = read_table(out / "density_windows.csv");
  std::map<std::string, std::map<double, double>> amplitude;
  for (size_t row = 0; row < windows.size(); ++row)
    amplitude[windows.text(row, "run")][windows.at(row, "from")] = windows.at(row, "amplitude");
  const auto late = [&](const std::string& run) { return amplitude[run][80]; };
  EXPECT_GT(late("SSPH, k = 1e4"), 5 * late("SSPH, k = 1e5"));
  EXPECT_GT(late("SSPH, k = 1e5"), 2 * late("SSPH, k = 1e6"));
  EXPECT_GT(late("SSPH, k = 1e6"), late("IISPH"));
  for (const char* run : {"SSPH, k = 1e4", "SSPH, k = 1e5", "SSPH, k = 1e6"})
    EXPECT_GT(amplitude[run][0], 1.5 * amplitude[run][80]) << run;
}

TEST(QuickStudy, CostTakesThePublishedIterations) {
  const TemporaryFolder folder;
  const Table costs = read_table(run_quick("cost", folder) / "cost.csv");
  int compared = 0;
  for (size_t row = 0; row < costs.size(); ++row) {
    if (costs.text(row, "method").starts_with("SSPH")) continue;
    const double theirs = costs.at(row, "their_iterations"), ours = costs.at(row, "iterations");
    if (costs.text(row, "method") == "IISPH, Jacobi") {
      ++compared;
      EXPECT_NEAR(ours, theirs, 0.02 * theirs);
    } else {
      EXPECT_LT(ours, 1.01 * theirs);
    }
  }
  EXPECT_EQ(compared, 7);
}

/// The least error of a quantity over the methods.
double best_error(const Table& table, const std::string& machine, const std::string& name,
                  const std::string& quantity) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t row = 0; row < table.size(); ++row) {
    if (table.text(row, "case") == name && table.text(row, "quantity") == quantity &&
        table.text(row, "machine") == machine)
      best = std::min(best, table.at(row, "error"));
  }
  return best;
}

TEST(QuickStudy, ValidationIsNearItsReferencesOnEveryMachine) {
  const TemporaryFolder folder;
  const Table table = read_table(run_quick("validate", folder) / "validate.csv");
  for (const std::string machine : {"double", "float", "gpu"}) {
    const auto best = [&](const std::string& name, const std::string& quantity) {
      return best_error(table, machine, name, quantity);
    };
    EXPECT_LT(best("oscillating_drop", "semi-axes after a period"), 0.02) << machine;
    EXPECT_LT(best("oscillating_drop", "period"), 0.01) << machine;
    EXPECT_LT(best("elliptic_drop", "minor semi-axis"), 0.08) << machine;
    EXPECT_LT(best("dam_break", "height"), 0.06) << machine;
    EXPECT_LT(best("dam_break", "front_offset"), 0.05) << machine;
    EXPECT_LT(best("hydrostatic_tank", "pressure"), 0.08) << machine;
    EXPECT_LT(best("standing_wave", "period"), 0.05) << machine;
    EXPECT_LT(best("free_fall", "centre of mass"), machine == "double" ? 1e-10 : 1e-4) << machine;
  }

  std::map<std::string, int> machines;
  for (size_t row = 0; row < table.size(); ++row) {
    EXPECT_NE(table.text(row, "quantity"), "valid")
        << table.text(row, "case") << ' ' << table.text(row, "method");
    ++machines[table.text(row, "machine")];
  }
  EXPECT_GT(machines["double"], 20);
  EXPECT_EQ(machines["float"], machines["double"]);
  EXPECT_EQ(machines["gpu"], machines["double"]);
}

TEST(QuickStudy, ParetoHasErrorsOfEveryKind) {
  const TemporaryFolder folder;
  const Table table = read_table(run_quick("pareto", folder) / "pareto.csv");
  ASSERT_EQ(table.size(), 12u);
  for (size_t row = 0; row < table.size(); ++row) {
    EXPECT_EQ(table.at(row, "valid"), 1);
    EXPECT_GT(table.at(row, "seconds_per_time"), 0);
    EXPECT_LT(table.at(row, "compression_mean"), 0.01);
    const bool tank = table.text(row, "scene") == "hydrostatic_tank";
    EXPECT_LT(table.at(row, "reference_error"), tank ? 0.4 : 0.1) << table.text(row, "scene");
    EXPECT_EQ(table.text(row, "distance").empty(), tank);
    if (!tank) {
      EXPECT_LT(table.at(row, "distance"), 0.5);
    }
  }
}

}  // namespace
}  // namespace sluice::test
