// The summary: its keys, its means computed again from the series, and settings that make the same run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/model/plan.hpp"
#include "core/output/output_file.hpp"
#include "core/output/summary.hpp"
#include "sluice/load.hpp"
#include "sluice/version.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

struct Outputs {
  nlohmann::ordered_json summary;
  Table series;
  std::string state;
};

Outputs run(const std::string& scene, const Words& more) {
  const TemporaryFolder folder;
  Words words{"run",       scene,      "--quiet",  "--threads",  "1",       "--precision", "double",
              "--summary", "sum.json", "--series", "series.csv", "--state", "state.csv"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  return {read_json(folder / "sum.json"), read_table(folder / "series.csv"), read_file(folder / "state.csv")};
}

TEST(CliSummary, HasItsKeysInOrder) {
  const auto summary = run("breaking_dam", {"--steps", "3"}).summary;
  Words keys;
  for (const auto& [key, value] : summary.items()) keys.push_back(key);
  EXPECT_EQ(keys, (Words{"format",
                         "version",
                         "commit",
                         "scene",
                         "title",
                         "backend",
                         "device",
                         "precision",
                         "threads",
                         "fluid",
                         "boundary",
                         "steps",
                         "time",
                         "valid",
                         "failure",
                         "lost",
                         "iterations_mean",
                         "iterations_max",
                         "not_converged",
                         "compression_mean",
                         "compression_max",
                         "cfl_max",
                         "seconds",
                         "particle_sweeps_per_second",
                         "settings",
                         "start_from"}));
  EXPECT_EQ(summary["format"], 1);
  EXPECT_EQ(summary["version"], version());
  EXPECT_EQ(summary["commit"].is_null() ? "" : summary["commit"], commit());
  EXPECT_EQ(summary["scene"], "breaking_dam");
  EXPECT_EQ(summary["title"], "Breaking dam");
  EXPECT_EQ(summary["backend"], "cpu");
  EXPECT_TRUE(summary["device"].is_string() && !summary["device"].get<std::string>().empty());
  EXPECT_EQ(summary["precision"], "double");
  EXPECT_EQ(summary["threads"], 1);
  EXPECT_EQ(summary["fluid"], 660);
  EXPECT_EQ(summary["boundary"], 591);
  EXPECT_EQ(summary["steps"], 3);
  EXPECT_EQ(summary["time"], 0.12);
  EXPECT_EQ(summary["valid"], true);
  EXPECT_TRUE(summary["failure"].is_null());
  for (const char* key :
       {"format", "threads", "fluid", "boundary", "steps", "lost", "iterations_max", "not_converged"})
    EXPECT_TRUE(summary[key].is_number_integer()) << key;
  for (const char* key : {"time", "iterations_mean", "compression_mean", "compression_max", "cfl_max",
                          "particle_sweeps_per_second"})
    EXPECT_TRUE(summary[key].is_number_float()) << key;
  const auto other = run_program(
      {"run", "breaking_dam", "--steps", "1", "--threads", "3", "--quiet", "--summary", "/dev/stdout"});
  EXPECT_EQ(nlohmann::json::parse(other.out)["precision"], "float");
  EXPECT_EQ(nlohmann::json::parse(other.out)["threads"], 3);
}

TEST(CliSummary, AgreesWithTheSeries) {
  for (const Words& words : {Words{"--time", "6"},
                             {"--steps", "20", "--set", "pressure.iisph.max_iterations=3"},
                             {"--time", "1", "--set", "pressure.method=ssph"}}) {
    const auto [summary, series, state] = run("breaking_dam", words);
    const auto mean = [&](const char* name) {
      double sum = 0;
      for (const double value : series.column(name)) sum += value;
      return sum / static_cast<double>(series.size());
    };
    const auto most = [&](const char* name) { return std::ranges::max(series.column(name)); };
    EXPECT_EQ(summary["steps"], series.size());
    EXPECT_EQ(summary["time"], series.column("time").back());
    EXPECT_NEAR(summary["iterations_mean"].get<double>(), mean("iterations"), 1e-12 * mean("iterations"));
    EXPECT_EQ(summary["iterations_max"].get<double>(), most("iterations"));
    EXPECT_EQ(summary["not_converged"], std::ranges::count(series.column("converged"), 0.0));
    EXPECT_NEAR(summary["compression_mean"].get<double>(), mean("mean_compression"),
                1e-12 * mean("mean_compression"));
    EXPECT_EQ(summary["compression_max"].get<double>(), most("max_compression"));
    EXPECT_EQ(summary["cfl_max"].get<double>(), most("cfl"));
    EXPECT_EQ(summary["lost"].get<double>(), series.column("lost").back());
  }
  EXPECT_GT(run("breaking_dam", {"--steps", "20", "--set", "pressure.iisph.max_iterations=3"})
                .summary["not_converged"],
            0);
}

TEST(CliSummary, CountsTheParticlesThatAreLostAtTheEnd) {
  EXPECT_EQ(run("breaking_dam", {"--time", "2.4", "--set", "boundary.container=[]"}).summary["lost"], 22);
}

TEST(CliSummary, TimesTheStagesOfThePlan) {
  for (const Words& overrides : {Words{},
                                 {"pressure.method=ssph"},
                                 {"viscosity.coefficient=0"},
                                 {"boundary.container=[]"},
                                 {"boundary.model=akinci"}}) {
    Words words{"--steps", "30"}, planned, timed;
    for (const std::string& change : overrides) words.insert(words.end(), {"--set", change});
    const auto summary = run("breaking_dam", words).summary;
    for (const Stage stage : make_plan(model_of(load_scene("breaking_dam", overrides))).stages()) {
      const std::string name(info(stage).name);
      const bool known = std::ranges::find(planned, name) != planned.end();
      if (!known && stage != Stage::pseudo_mass) planned.push_back(name);  // which is no part of a step
    }
    double all = 0, sweep = 0;
    for (const auto& [name, seconds] : summary["seconds"]["stages"].items()) {
      timed.push_back(name);
      EXPECT_GT(seconds.get<double>(), 0) << name;
      all += seconds.get<double>();
      for (const char* part :
           {"pressure_acceleration", "pressure_operator", "residual", "stop_test", "pressure_update"})
        sweep += name == part ? seconds.get<double>() : 0;
    }
    EXPECT_EQ(timed, planned);
    EXPECT_GT(summary["seconds"]["cpu"].get<double>(), 0);
    EXPECT_TRUE(summary["seconds"]["busy"].is_boolean());
    EXPECT_TRUE(summary["seconds"]["others"].is_null());  // less than a second
    EXPECT_GE(summary["seconds"]["total"].get<double>(), all);
    const double sweeps = 660 * 30 * summary["iterations_mean"].get<double>();
    EXPECT_NEAR(summary["particle_sweeps_per_second"].get<double>(), sweeps / sweep, 1e-9 * sweeps / sweep);
  }
}

TEST(CliSummary, SettingsAreTheSceneAsRun) {
  const auto settings =
      run("breaking_dam", {"--steps", "1", "--set", "fluid.gravity=[1,-5]", "--fps", "12.5", "--size",
                           "320x240", "--colour", "density", "--set", "pressure.method=ssph"})
          .summary["settings"];
  EXPECT_EQ(settings["fluid"]["gravity"], (std::vector<double>{1, -5}));
  EXPECT_EQ(settings["output"]["fps"], 12.5);
  EXPECT_EQ(settings["output"]["size"], (std::vector<int>{320, 240}));
  EXPECT_EQ(settings["output"]["colour"], "density");
  EXPECT_EQ(settings["pressure"]["method"], "ssph");
  EXPECT_EQ(settings["pressure"]["iisph"]["omega"], 0.5) << "a default is written out";
  EXPECT_EQ(settings["time"]["dt"], 0.01) << "that of the method";
  EXPECT_EQ(settings["particles"]["spacing"], 8);
}

TEST(CliSummary, SettingsMakeTheSameRunAgain) {
  for (const std::string scene : {"breaking_dam", "template", "inclined_plane"}) {
    const TemporaryFolder folder;
    const Words jitter{"--steps", "10",           "--set", "fluid.jitter=0.1",
                       "--set",   "fluid.seed=7", "--set", "time.dt=0.015"};
    const Outputs once = run(scene, jitter);
    write_file(folder / "again.toml", to_toml(once.summary["settings"]));
    const Outputs again = run(folder / "again.toml", {"--steps", "10"});
    EXPECT_TRUE(again.state == once.state) << scene;
    EXPECT_EQ(again.summary["settings"].dump(), once.summary["settings"].dump()) << scene;
  }
}

}  // namespace
}  // namespace sluice::test
