// The series: its header, its rows, and each of its numbers computed again from states of the same run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

struct Outputs {
  Table series, state;
};

Outputs run(const std::string& scene, const Words& more) {
  const TemporaryFolder folder;
  Words words{"run",
              scene,
              "--quiet",
              "--threads",
              "1",
              "--precision",
              "double",
              "--series",
              folder / "series.csv",
              "--state",
              folder / "state.csv"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.code, 0) << result.err;
  return {read_table(folder / "series.csv"), read_table(folder / "state.csv")};
}

void expect_close(double found, double expected, const std::string& what) {
  EXPECT_NEAR(found, expected, 1e-12 * std::abs(expected)) << what;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

double mean(const std::vector<double>& values) { return sum(values) / static_cast<double>(values.size()); }

TEST(CliSeries, HasOneRowPerStep) {
  const auto [series, state] = run("breaking_dam", {"--steps", "12"});
  EXPECT_EQ(series.header,
            "step,time,dt,iterations,residual,mean_density,mean_compression,max_compression,kinetic_energy,"
            "potential_energy,com_x,com_y,max_speed,cfl,wall_force_x,wall_force_y,lost,converged");
  ASSERT_EQ(series.size(), 12u);
  for (size_t row = 0; row < 12; ++row) {
    EXPECT_EQ(series.text(row, "step"), std::to_string(row + 1));
    EXPECT_DOUBLE_EQ(series.at(row, "time"), 0.04 * static_cast<double>(row + 1));
    EXPECT_EQ(series.at(row, "dt"), 0.04);
    EXPECT_GE(series.at(row, "iterations"), 2);
    EXPECT_LT(series.at(row, "residual"), 1e-3);
    EXPECT_GT(series.at(row, "residual"), 0);
    EXPECT_EQ(series.text(row, "converged"), "1");
  }
  EXPECT_EQ(run("breaking_dam", {"--steps", "0"}).series.size(), 0u);
}

// m = 64, h = 8, g = 9.81, rho0 = 1.
TEST(CliSeries, AgreesWithTheState) {
  for (const char* method : {"iisph", "ssph", "wcsph"}) {
    const auto [series, state] =
        run("breaking_dam", {"--time", "4", "--set", std::string("pressure.method=") + method});
    const size_t last = series.size() - 1;
    const auto vx = state.column("vx"), vy = state.column("vy"), density = state.column("density");
    double speed2 = 0, fastest2 = 0, compression = 0, most = 0;
    for (size_t i = 0; i < state.size(); ++i) {
      const double v2 = vx[i] * vx[i] + vy[i] * vy[i];
      speed2 += v2;
      fastest2 = std::max(fastest2, v2);
      compression += std::max(density[i] - 1, 0.0);
      most = std::max(most, density[i] - 1);
    }
    expect_close(series.at(last, "kinetic_energy"), 0.5 * 64 * speed2, "kinetic_energy");
    expect_close(series.at(last, "potential_energy"), 64 * 9.81 * sum(state.column("y")), "potential_energy");
    expect_close(series.at(last, "com_x"), mean(state.column("x")), "com_x");
    expect_close(series.at(last, "com_y"), mean(state.column("y")), "com_y");
    expect_close(series.at(last, "max_speed"), std::sqrt(fastest2), "max_speed");
    expect_close(series.at(last, "cfl"), std::sqrt(fastest2) * series.at(last, "dt") / 8, "cfl");
    expect_close(series.at(last, "mean_density"), mean(density), "mean_density");
    expect_close(series.at(last, "mean_compression"), compression / 660, "mean_compression");
    expect_close(series.at(last, "max_compression"), most, "max_compression");
    EXPECT_GT(compression, 0) << "nothing is compared";
    EXPECT_EQ(series.text(last, "lost"), "0");
  }
}

TEST(CliSeries, PotentialEnergyFollowsAnyGravity) {
  const auto [series, state] = run("breaking_dam", {"--steps", "5", "--set", "fluid.gravity=[3, -5]"});
  expect_close(series.at(4, "potential_energy"),
               64 * (5 * sum(state.column("y")) - 3 * sum(state.column("x"))), "potential_energy");
}

// Without viscosity only gravity and the walls change the momentum: m sum dv/dt = m n g - F.
TEST(CliSeries, WallForceIsWhatChangesTheMomentum) {
  for (const char* method : {"iisph", "ssph", "wcsph"}) {
    const Words inviscid{"--set", "viscosity.coefficient=0", "--set",
                         std::string("pressure.method=") + method, "--steps"};
    Words before = inviscid, after = inviscid;
    before.push_back("60");
    after.push_back("61");
    const Outputs first = run("breaking_dam", before), second = run("breaking_dam", after);
    const double dt = second.series.at(60, "dt"), weight = 64 * 660 * 9.81;
    const auto rate = [&](const char* component) {
      return 64 * (sum(second.state.column(component)) - sum(first.state.column(component))) / dt;
    };
    const double x = second.series.at(60, "wall_force_x"), y = second.series.at(60, "wall_force_y");
    EXPECT_NEAR(rate("vx"), -x, 1e-8 * weight) << method;
    EXPECT_NEAR(rate("vy"), -weight - y, 1e-8 * weight) << method;
    EXPECT_LT(x, -0.01 * weight) << "the fluid leans on the left wall";
    EXPECT_LT(y, -0.1 * weight) << "and on the floor";
  }
}

// 1050 particles of mass 100.
TEST(CliSeries, WallsCarryTheWeightOfAFluidAtRest) {
  const Table series = run("resting_fluid", {"--steps", "150"}).series;
  const auto x = series.column("wall_force_x"), y = series.column("wall_force_y");
  const double weight = 1050 * 100 * 9.81;
  EXPECT_NEAR(mean({y.begin() + 50, y.end()}), -weight, 0.02 * weight);
  EXPECT_NEAR(mean({x.begin() + 50, x.end()}), 0, 0.001 * weight);
}

// Without walls everything falls: the lowest row of 22 passes y = 0 after sqrt(2 24/9.81) = 2.21, the next
// after 2.55.
TEST(CliSeries, LostCountsTheParticlesBelowTheDomain) {
  const auto [series, state] = run("breaking_dam", {"--time", "2.4", "--set", "boundary.container=[]"});
  EXPECT_EQ(series.at(series.size() - 1, "lost"), 22);
  const auto y = state.column("y");
  EXPECT_EQ(std::ranges::count_if(y, [](double value) { return value < 0; }), 22);
  EXPECT_EQ(series.at(49, "lost"), 0) << "at time 2";
  EXPECT_EQ(series.text(49, "wall_force_y"), "0");
}

// Ten particles thrown out of the domain 400 wide and 600 high; the run ends with the first two of them.
TEST(CliSeries, LostKnowsTheSidesButNoCeiling) {
  const auto lost = [](const std::string& velocity) {
    const ProgramResult result = run_program(
        {"run", "breaking_dam", "--threads", "1", "--quiet", "--time", "1.4", "--set",
         "boundary.container=[]", "--set", "fluid.gravity=[0,0]", "--set", "fluid.rect.0.min=[184,300]",
         "--set", "fluid.rect.0.max=[224,316]", "--set", "fluid.rect.0.velocity=" + velocity});
    return result.code == 1 && result.err.find(" of 10 particles are lost") != std::string::npos;
  };
  EXPECT_TRUE(lost("[300,0]"));
  EXPECT_TRUE(lost("[-300,0]"));
  EXPECT_TRUE(lost("[0,-300]"));
  EXPECT_FALSE(lost("[0,300]")) << "above an open top is not lost";
}

TEST(CliSeries, AStateEquationHasNoIterations) {
  const Table series = run("breaking_dam", {"--steps", "5", "--set", "pressure.method=ssph"}).series;
  for (size_t row = 0; row < 5; ++row) {
    EXPECT_EQ(series.text(row, "iterations"), "0");
    EXPECT_EQ(series.text(row, "residual"), "0");
    EXPECT_EQ(series.text(row, "converged"), "1");
  }
}

TEST(CliSeries, AStepThatReachesTheCapDidNotConverge) {
  const Table series =
      run("resting_fluid", {"--steps", "5", "--set", "pressure.iisph.max_iterations=3"}).series;
  for (size_t row = 0; row < 5; ++row) {
    EXPECT_EQ(series.text(row, "iterations"), "3");
    EXPECT_EQ(series.text(row, "converged"), series.at(row, "residual") < 1e-3 ? "1" : "0");
  }
  EXPECT_EQ(series.text(4, "converged"), "0");
}

}  // namespace
}  // namespace sluice::test
