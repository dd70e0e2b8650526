// Runs that go bad end with exit code 1, say where, and still leave the series, the summary and the last
// finite state.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct BadRun {
  ProgramResult result;
  Table series, state;
  nlohmann::ordered_json summary, failure;
};

/// Runs breaking_dam with these words and checks what all invalid runs have in common.
BadRun run_badly(const Words& more) {
  const TemporaryFolder folder;
  Words words{"run",        "breaking_dam", "--threads", "1",         "--quiet", "--series",
              "series.csv", "--state",      "state.csv", "--summary", "sum.json"};
  words.insert(words.end(), more.begin(), more.end());
  BadRun bad;
  bad.result = run_program(words, folder.path);
  EXPECT_EQ(bad.result.code, 1) << bad.result.err;
  EXPECT_EQ(names_in(folder.path), (Words{"series.csv", "state.csv", "sum.json"}));
  bad.series = read_table(folder / "series.csv");
  bad.state = read_table(folder / "state.csv");
  bad.summary = read_json(folder / "sum.json");
  bad.failure = bad.summary["failure"];

  EXPECT_EQ(bad.summary["valid"], false);
  Words keys;
  for (const auto& [key, value] : bad.failure.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Words{"step", "time", "id", "x", "y", "reason"}));
  // The run ends with the step that failed.
  EXPECT_EQ(bad.failure["step"], bad.summary["steps"]);
  EXPECT_EQ(bad.failure["time"], bad.summary["time"]);
  EXPECT_EQ(bad.series.size(), bad.summary["steps"].get<size_t>());
  // The message has it all too; quiet runs have it alone.
  const std::string& err = bad.result.err;
  EXPECT_TRUE(has(err, "step " + bad.failure["step"].dump() + ",")) << err;
  EXPECT_TRUE(has(err, "particle " + bad.failure["id"].dump() + " ")) << err;
  EXPECT_TRUE(has(err, bad.failure["reason"].get<std::string>())) << err;
  char time[40];
  std::snprintf(time, sizeof time, "time %g,", bad.failure["time"].get<double>());
  EXPECT_TRUE(has(err, time)) << err;
  EXPECT_EQ(bad.result.out, "");

  EXPECT_EQ(bad.state.size(), 660u);
  EXPECT_TRUE(std::isfinite(bad.failure["x"].get<double>()) && std::isfinite(bad.failure["y"].get<double>()));
  for (const std::string& name : bad.state.names) {
    for (const double value : bad.state.column(name)) EXPECT_TRUE(std::isfinite(value)) << name;
  }
  return bad;
}

size_t id_of(const BadRun& bad) { return bad.failure["id"].get<size_t>(); }

TEST(CliInvalidRuns, AFluidThatExplodes) {
  const BadRun bad = run_badly({"--precision", "double", "--steps", "50", "--set", "pressure.method=ssph",
                                "--set", "pressure.ssph.stiffness=1e9"});
  const size_t last = bad.series.size() - 1;
  EXPECT_GT(bad.series.at(last, "cfl"), 100);
  EXPECT_LE(bad.series.at(last - 1, "cfl"), 100);
  EXPECT_EQ(bad.summary["cfl_max"].get<double>(), bad.series.at(last, "cfl"));
  EXPECT_TRUE(has(bad.failure["reason"], "100")) << bad.failure["reason"];
  // The state is that after the failing step, and the particle its fastest.
  const size_t id = id_of(bad);
  EXPECT_NEAR(std::hypot(bad.state.at(id, "vx"), bad.state.at(id, "vy")), bad.series.at(last, "max_speed"),
              1e-9 * bad.series.at(last, "max_speed"));
  EXPECT_EQ(bad.state.at(id, "x"), bad.failure["x"].get<double>());
  EXPECT_EQ(bad.state.at(id, "y"), bad.failure["y"].get<double>());
}

// With h = 8 and dt = 0.04, 20000 is a cfl of 100.
TEST(CliInvalidRuns, ASpeedOfMoreThanHundredSpacingsPerStep) {
  const Words still{"--steps", "1",
                    "--set",   "fluid.gravity=[0,0]",
                    "--set",   "boundary.container=[]",
                    "--set",   "domain.max=[4000,600]",
                    "--set",   "pressure.method=ssph",
                    "--set",   "time.dt=0.04",
                    "--set",   "pressure.ssph.stiffness=1e-9",
                    "--set"};
  Words slow = still, fast = still;
  slow.push_back("fluid.rect.0.velocity=[19990,0]");
  fast.push_back("fluid.rect.0.velocity=[20010,0]");
  run_badly(fast);
  slow.insert(slow.begin(), {"run", "breaking_dam", "--threads", "1", "--quiet"});
  EXPECT_EQ(run_program(slow).code, 0);
}

TEST(CliInvalidRuns, AFluidThatIsLost) {
  const BadRun bad = run_badly({"--precision", "double", "--set", "boundary.container=[]"});
  const size_t last = bad.series.size() - 1;
  EXPECT_GT(bad.series.at(last, "lost"), 66);  // a tenth of 660
  EXPECT_LE(bad.series.at(last - 1, "lost"), 66);
  EXPECT_EQ(bad.summary["lost"].get<double>(), bad.series.at(last, "lost"));
  EXPECT_TRUE(has(bad.failure["reason"], "lost")) << bad.failure["reason"];
  EXPECT_LT(bad.state.at(id_of(bad), "y"), 0);
  EXPECT_EQ(bad.state.at(id_of(bad), "y"), bad.failure["y"].get<double>());
}

// A tenth itself is still allowed: three rows of 22 are below after 2.86, the fourth at 3.12.
TEST(CliInvalidRuns, ATenthMayBeLost) {
  const ProgramResult result = run_program(
      {"run", "breaking_dam", "--threads", "1", "--quiet", "--time", "3", "--set", "boundary.container=[]"});
  EXPECT_EQ(result.code, 0) << result.err;
}

// A single column falls freely for two seconds; a fluid this stiff overflows where it lands.
TEST(CliInvalidRuns, AValueThatIsNotFinite) {
  const Words words{"--precision", "float",
                    "--set",       "pressure.method=wcsph",
                    "--set",       "pressure.wcsph={kappa=100,gamma=1e6,dt=0.01}",
                    "--set",       "fluid.rect.0.min=[\"10h\",\"5h\"]",
                    "--set",       "fluid.rect.0.max=[\"11h\",\"665h\"]",
                    "--set",       "domain.max=[400,6000]"};
  const BadRun bad = run_badly(words);
  const uint64_t step = bad.failure["step"];
  ASSERT_GT(step, 1u);
  EXPECT_TRUE(has(bad.failure["reason"], "not finite")) << bad.failure["reason"];
  EXPECT_FALSE(std::isfinite(bad.series.at(step - 1, "kinetic_energy")));
  EXPECT_TRUE(std::isfinite(bad.series.at(step - 2, "kinetic_energy")));
  EXPECT_TRUE(bad.summary["cfl_max"].is_null());
  EXPECT_TRUE(bad.summary["compression_max"].is_number());

  // The last finite state is that of the step before, to the last digit, and the particle was there.
  const TemporaryFolder folder;
  Words before{
      "run",     "breaking_dam",      "--threads", "1", "--quiet", "--steps", std::to_string(step - 1),
      "--state", folder / "state.csv"};
  before.insert(before.end(), words.begin(), words.end());
  ASSERT_EQ(run_program(before).code, 0);
  EXPECT_TRUE(read_table(folder / "state.csv").rows == bad.state.rows);
  EXPECT_EQ(static_cast<float>(bad.state.at(id_of(bad), "x")), bad.failure["x"].get<float>());
  EXPECT_EQ(static_cast<float>(bad.state.at(id_of(bad), "y")), bad.failure["y"].get<float>());
}

// The box of the WCSPH page, one and a half times beyond its time step.
TEST(CliInvalidRuns, ABoxThatBlowsUp) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(
      {"run", "wcsph_box", "--set", "time.dt=0.0045", "--quiet", "--summary", "s.json"}, folder.path);
  EXPECT_EQ(result.code, 1);
  for (const char* part : {"invalid run: a particle moved by", "at step ", "particle "})
    EXPECT_TRUE(has(result.err, part)) << result.err;
  const auto failure = read_json(folder / "s.json")["failure"];
  EXPECT_LT(failure["step"].get<int>(), 100);
  EXPECT_LT(failure["id"].get<int>(), 1200);
}

}  // namespace
}  // namespace sluice::test
