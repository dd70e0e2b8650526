// The state file: its columns and digits, the start, and the same bytes whatever the threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

/// The bytes of the state after breaking_dam with these words.
std::string state_of(const Words& more) {
  const TemporaryFolder folder;
  Words words{"run", "breaking_dam", "--quiet", "--state", "state.csv"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(names_in(folder.path), std::vector<std::string>{"state.csv"});
  return result.code == 0 ? read_file(folder / "state.csv") : "";
}

Table table_of(const Words& more) {
  const TemporaryFolder folder;
  Words words{"run", "breaking_dam", "--quiet", "--threads", "1", "--state", folder / "state.csv"};
  words.insert(words.end(), more.begin(), more.end());
  EXPECT_EQ(run_program(words).code, 0);
  return read_table(folder / "state.csv");
}

std::string printed(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

TEST(CliState, OneRowPerParticleInTheOrderOfTheIds) {
  const Table state = table_of({"--steps", "60"});
  EXPECT_EQ(state.header, "id,x,y,vx,vy,density,pressure");
  ASSERT_EQ(state.size(), 660u);
  for (size_t i = 0; i < state.size(); ++i) EXPECT_EQ(state.text(i, "id"), std::to_string(i));
}

TEST(CliState, NumbersReadBackAsTheyWere) {
  const Table doubles = table_of({"--steps", "60", "--precision", "double"});
  const Table floats = table_of({"--steps", "60", "--precision", "float"});
  size_t long_doubles = 0, long_floats = 0;
  for (const std::string name : {"x", "y", "vx", "vy", "density", "pressure"}) {
    for (size_t i = 0; i < doubles.size(); ++i) {
      const std::string &wide = doubles.text(i, name), &narrow = floats.text(i, name);
      EXPECT_EQ(printed("%.17g", std::strtod(wide.c_str(), nullptr)), wide);
      EXPECT_EQ(printed("%.9g", static_cast<double>(std::strtof(narrow.c_str(), nullptr))), narrow);
      long_doubles += wide.size() > 16 ? 1u : 0u;
      long_floats += narrow.size() > 8 ? 1u : 0u;
    }
  }
  EXPECT_GT(long_doubles, 3000u);
  EXPECT_GT(long_floats, 3000u);
}

// Rows of 22 from (3h, 3h), h = 8.
TEST(CliState, ZeroStepsShowTheStart) {
  for (const char* precision : {"float", "double"}) {
    const Table state = table_of({"--steps", "0", "--precision", precision});
    ASSERT_EQ(state.size(), 660u);
    for (size_t i = 0; i < state.size(); ++i) {
      EXPECT_EQ(state.at(i, "x"), 24 + 8 * static_cast<double>(i % 22));
      EXPECT_EQ(state.at(i, "y"), 24 + 8 * static_cast<double>(i / 22));
      for (const char* name : {"vx", "vy", "density", "pressure"})
        EXPECT_EQ(state.text(i, name), "0") << name;
    }
  }
}

TEST(CliState, TheStartIsThatAfterTheJitterAndRelaxation) {
  const Words jitter{"--steps", "0", "--precision", "double", "--set", "fluid.jitter=0.25"};
  Words relaxed = jitter;
  relaxed.insert(relaxed.end(), {"--set", "fluid.relax=3"});
  const Table lattice = table_of({"--steps", "0", "--precision", "double"}), moved = table_of(jitter),
              projected = table_of(relaxed);
  double largest = 0, least = 1;
  size_t apart = 0;
  for (size_t i = 0; i < lattice.size(); ++i) {
    for (const char* name : {"x", "y"}) {
      const double displacement = std::abs(moved.at(i, name) - lattice.at(i, name)) / 8;
      largest = std::max(largest, displacement);
      least = std::min(least, displacement);
    }
    apart += projected.text(i, "x") != moved.text(i, "x") ? 1u : 0u;
    EXPECT_EQ(projected.text(i, "density"), "0");
    EXPECT_EQ(projected.text(i, "pressure"), "0");
    EXPECT_EQ(projected.text(i, "vy"), "0");
  }
  EXPECT_LE(largest, 0.25);
  EXPECT_GT(largest, 0.24);
  EXPECT_LT(least, 0.01);
  EXPECT_GT(apart, 300u);
}

TEST(CliState, DensityAndPressureAreThoseOfTheLastStep) {
  const Table first = table_of({"--steps", "1", "--precision", "double", "--set", "pressure.method=ssph"});
  // The state equation with k = 7e5 and rho0 = 1; the start's density in the interior of the lattice.
  size_t pressed = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    const double rho = first.at(i, "density"), p = std::max(7e5 * (rho - 1), 0.0);
    EXPECT_NEAR(first.at(i, "pressure"), p, 1e-9 * 7e5);
    pressed += p > 0 ? 1u : 0u;
  }
  EXPECT_GT(pressed, 500u);
  EXPECT_NEAR(first.at(22 * 10 + 10, "density"), 1.000862, 1e-6);
}

TEST(CliState, RunsRepeatToTheLastByte) {
  for (const char* precision : {"float", "double"}) {
    const Words words{"--time", "5", "--precision", precision, "--threads", "1"};
    const std::string once = state_of(words);
    EXPECT_GT(once.size(), 10000u);
    EXPECT_TRUE(once == state_of(words)) << precision;
  }
  EXPECT_FALSE(state_of({"--steps", "5", "--threads", "1", "--precision", "float"}) ==
               state_of({"--steps", "5", "--threads", "1", "--precision", "double"}));
}

TEST(CliState, ThreadsDoNotChangeABit) {
  for (const char* precision : {"float", "double"}) {
    std::vector<std::string> states, series;
    for (const char* threads : {"1", "2", "4"}) {
      const TemporaryFolder folder;
      // Threads that wait without spinning keep this fast on a machine that is busy otherwise.
      RunningProgram program(
          {"run", "breaking_dam", "--set", "particles.spacing=2.5", "--set", "viscosity.coefficient=50",
           "--set", "time.dt=0.003", "--steps", "20", "--quiet", "--precision", precision, "--threads",
           threads, "--state", folder / "state.csv", "--series", folder / "series.csv"},
          {.environment = {"OMP_WAIT_POLICY=passive"}, .terminal = false});
      ASSERT_EQ(program.wait().code, 0);
      states.push_back(read_file(folder / "state.csv"));
      series.push_back(read_file(folder / "series.csv"));
      EXPECT_TRUE(states.back() == states.front()) << threads << " threads in " << precision;
      EXPECT_TRUE(series.back() == series.front()) << threads << " threads in " << precision;
    }
  }
}

}  // namespace
}  // namespace sluice::test
