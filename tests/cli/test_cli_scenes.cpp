// `sluice scenes` and `sluice info`: every shipped scene with its counts, its plan, its memory, and what the
// machine offers. A scene is found by path as well as by name.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "core/model/plan.hpp"
#include "core/output/summary.hpp"
#include "core/scene/keys.hpp"
#include "sluice/load.hpp"
#include "sluice/version.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern));
}

TEST(CliScenes, EveryShippedSceneIsListedWithItsCounts) {
  const ProgramResult result = run_program({"scenes"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  size_t scenes = 0;
  for (const auto& entry : fs::directory_iterator(SLUICE_SOURCE_DIR "/scenes")) {
    if (entry.is_directory()) continue;  // scenes of a study
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(has(result.out, fmt::format("\n{} +[1-9][0-9]* +[0-9]+ ", name))) << name;
    ++scenes;
  }
  EXPECT_GE(scenes, 6u);
  EXPECT_TRUE(has(result.out, "breaking_dam +660 +591 +iisph +0.04 +50 +Breaking dam\n"));
  EXPECT_TRUE(has(result.out, "leaking_dam +4400 +2799 +iisph +0.01 +20 "));
  EXPECT_TRUE(has(result.out, "resting_fluid +1050 +471 +iisph +0.1 +100 "));
}

TEST(CliScenes, TheKeysAreAReference) {
  const ProgramResult result = run_program({"scenes", "--keys"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, key_reference());
}

TEST(CliInfo, ASceneShowsItsCountsPlanAndMemory) {
  for (const char* name : {"breaking_dam", "leaking_dam"}) {
    const ProgramResult result = run_program({"info", name});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(
        has(result.out, "memory in float: [0-9]+ bytes per fluid particle, about [0-9.]+ [kMG]?B in all\n"));
    EXPECT_TRUE(
        has(result.out, "memory in double: [0-9]+ bytes per fluid particle, about [0-9.]+ [kMG]?B in all\n"));
    // The stages of the plan and their equations, in the order of the plan, and no others.
    size_t place = result.out.find("one step:"), lines = 0;
    for (const Stage stage : make_plan(model_of(load_scene(name))).stages()) {
      const std::string row = "\n    " + std::string(info(stage).name) + ' ';
      place = result.out.find(row, place);
      ASSERT_NE(place, std::string::npos) << row;
      const std::string line = result.out.substr(place + 1, result.out.find('\n', place + 1) - place - 1);
      EXPECT_TRUE(line.ends_with(info(stage).equation)) << line;
      ++place;
      ++lines;
    }
    const std::regex row("\n    [a-z]");
    EXPECT_EQ(std::distance(std::sregex_iterator(result.out.begin(), result.out.end(), row),
                            std::sregex_iterator()),
              static_cast<std::ptrdiff_t>(lines));
  }
  EXPECT_TRUE(has(run_program({"info", "breaking_dam"}).out, "660 fluid \\+ 591 boundary = 1251"));
  EXPECT_TRUE(has(run_program({"info", "leaking_dam"}).out, "4400 fluid \\+ 2799 boundary = 7199"));
}

TEST(CliInfo, TheMachineIsShown) {
  const ProgramResult result = run_program({"info"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.starts_with("sluice " + version() + "\n")) << result.out;
  EXPECT_TRUE(has(result.out, "processor: .+, [1-9][0-9]* threads?, .*memory free\n")) << result.out;
  EXPECT_TRUE(has(result.out, "\n0: .+OpenGL [4-9]\\.[0-9]")) << result.out;
}

TEST(CliScenes, APathAndANameAreTheSameScene) {
  const TemporaryFolder folder;
  fs::copy_file(SLUICE_SOURCE_DIR "/scenes/breaking_dam.toml", folder / "copy.toml");
  std::vector<std::string> states;
  for (const std::string scene :
       {"breaking_dam", SLUICE_SOURCE_DIR "/scenes/breaking_dam.toml", "copy.toml"}) {
    const ProgramResult result = run_program({"run", scene, "--steps", "20", "--threads", "1", "--quiet",
                                              "--state", "state.csv", "--summary", "summary.json"},
                                             folder.path);
    ASSERT_EQ(result.code, 0) << scene << result.err;
    states.push_back(read_file(folder / "state.csv"));
    EXPECT_EQ(states.back(), states.front()) << scene;
    EXPECT_EQ(read_json(folder / "summary.json")["scene"], scene == "copy.toml" ? "copy" : "breaking_dam");
  }
}

}  // namespace
}  // namespace sluice::test
