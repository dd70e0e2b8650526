// `sluice play` of a scene: every key does what the help says, and the window shows what a run without one
// draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/glm.hpp>

#include "tests/support/played.hpp"

namespace sluice::test {
namespace {

using Words = std::vector<std::string>;

/// The last picture that `sluice run` makes.
Png headless(const Words& words) {
  const TemporaryFolder folder;
  Words all{"run"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--quiet", "--frames", folder / "frames"});
  const ProgramResult result = run_program(all);
  EXPECT_EQ(result.code, 0) << result.err;
  std::vector<std::filesystem::path> names(std::filesystem::directory_iterator(folder / "frames"), {});
  return {read_file(*std::ranges::max_element(names))};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class PlayOn : public testing::TestWithParam<std::string> {};

TEST_P(PlayOn, ItsScreenshotIsTheHeadlessFrameOfThatStep) {
  const Words dam{"breaking_dam", "--backend", GetParam()};
  const auto after = [&](const char* steps, const Words& more) {
    return headless(with(with(dam, {"--steps", steps}), more));
  };
  Played played(with(dam, {"--overlay", "none", "--steps", "10", "--speed", "20"}));
  played.wait_for("paused at step 10, time 0.4, as asked for");
  const auto first = played.screenshot();
  EXPECT_EQ(first.name, "breaking_dam_000010.png");
  EXPECT_EQ(first.png, after("10", {"--overlay", "none"}));
  played.press({"Right"});
  const auto second = played.screenshot();
  EXPECT_EQ(second.name, "breaking_dam_000011.png");
  EXPECT_EQ(second.png, after("11", {"--overlay", "none"}));
  played.press({"c"});
  EXPECT_EQ(played.screenshot().png, after("11", {"--overlay", "none", "--colour", "density"}));
  played.press({"c"});
  const auto third = played.screenshot();
  EXPECT_EQ(third.name, "breaking_dam_000011_3.png") << "one that is there is kept";
  EXPECT_EQ(third.png, after("11", {"--overlay", "none", "--colour", "pressure"}));
  played.press({"c", "o"});
  EXPECT_EQ(played.screenshot().png, after("11", {"--overlay", "facts"}));
  EXPECT_EQ(played.quit().code, 0);
}

std::string backend_name(const testing::TestParamInfo<std::string>& backend) { return backend.param; }
INSTANTIATE_TEST_SUITE_P(Backends, PlayOn, testing::Values("cpu", "gpu"), backend_name);

TEST(Play, PausesGoesOnAndStartsAgain) {
  Played played({"breaking_dam", "--overlay", "none", "--speed", "10"});
  played.expect_title("Breaking dam – IISPH – Sluice");
  played.press({"space"});
  const int paused_at = std::stoi(played.wait_for("paused at step "));
  EXPECT_EQ(std::stoi(played.screenshot().name.substr(std::string("breaking_dam_").size())), paused_at);
  played.expect_title("Breaking dam – IISPH (paused) – Sluice");
  played.press({"space"});
  EXPECT_EQ(std::stoi(played.wait_for("goes on at step ")), paused_at);
  played.press({"space"});
  EXPECT_GE(std::stoi(played.wait_for("paused at step ")), paused_at);
  played.press({"r"});
  played.wait_for("from the start");
  // With a number more if the run was paused before its first step, too.
  EXPECT_TRUE(played.screenshot().name.starts_with("breaking_dam_000000"));
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, ChoosesMethodsParticlesAndTimeSteps) {
  Played played({"breaking_dam", "--steps", "0"});
  played.press({"1"});
  played.wait_for("sluice: SSPH, dt 0.01\n");
  played.expect_title("Breaking dam – SSPH (paused) – Sluice");
  played.press({"plus"});
  played.wait_for("sluice: dt 0.0125\n");
  played.press({"3"});
  played.wait_for("sluice: WCSPH, dt 0.01\n");
  played.press({"2"});
  played.wait_for("sluice: IISPH, dt 0.04\n");
  played.press({"minus", "minus"});
  played.wait_for("sluice: dt 0.032\n");
  played.wait_for("sluice: dt 0.0256\n");
  played.press({"plus", "plus", "bracketright"});
  played.wait_for("sluice: spacing 6.4, dt 0.032, 1102 particles\n");
  played.press({"bracketleft"});
  played.wait_for("sluice: spacing 8, dt 0.04, 660 particles\n");
  played.press({"bracketleft"});
  played.wait_for("sluice: spacing 10, dt 0.05, ");
  played.press({"Up", "Down", "Down"});
  played.wait_for("sluice: speed 2\n");
  played.wait_for("sluice: speed 1\n");
  played.wait_for("sluice: speed 0.5\n");
  EXPECT_EQ(played.quit().code, 0);
}

/// After `]` it is the scene with that spacing and time step, and after `+` the run goes on with the other.
TEST(Play, WhatIsChosenIsWhatIsSimulated) {
  Played played({"breaking_dam", "--steps", "0", "--overlay", "none", "--backend", "cpu"});
  played.press({"bracketright"});
  played.wait_for("spacing 6.4");
  played.press({"Right", "Right", "Right"});
  EXPECT_EQ(played.screenshot().png,
            headless({"breaking_dam", "--overlay", "none", "--set", "particles.spacing=6.4", "--set",
                      "time.dt=0.032", "--fps", "31.25", "--steps", "3"}));
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, GoesToTheNextAndThePreviousScene) {
  Played played({"breaking_dam", "--set", "fluid.jitter=0.1", "--speed", "0.01"});
  played.press({"n"});
  played.wait_for("sluice: falling_from_platform, dt 0.04\n");
  played.press({"p"});
  played.wait_for("sluice: breaking_dam, dt 0.04\n");
  played.press({"p"});
  played.wait_for("sluice: wcsph_box, dt 0.002\n");
  played.expect_size(800, 605);
  played.press({"bracketleft"});
  played.wait_for("sluice: spacing 0.0625, dt 0.0025, 768 particles\n");
  played.expect_title("Block of water in a box – WCSPH – Sluice");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, DragPansWheelZoomsAndZeroShowsAllAgain) {
  Played played({"breaking_dam", "--steps", "0", "--overlay", "none"});
  const Png whole = played.screenshot().png;
  played.xdotool("mousemove 200 300 mousedown 1 mousemove 230 320 mouseup 1");
  const Png moved = played.screenshot().png;
  EXPECT_NE(moved, whole);
  played.xdotool("mousemove 200 300 mousedown 1 mousemove 170 280 mouseup 1");
  EXPECT_EQ(played.screenshot().png, whole) << "dragged back";
  played.xdotool("mousemove 100 500 click 4 click 4");
  const Png near = played.screenshot().png;
  EXPECT_NE(near, whole);
  played.press({"0"});
  EXPECT_EQ(played.screenshot().png, whole);
  played.xdotool("mousemove 300 100 click 4 click 4");
  EXPECT_NE(played.screenshot().png, near) << "what is under the pointer stays there";
  played.press({"0"});
  played.xdotool("click 5");
  EXPECT_NE(played.screenshot().png, whole);
  EXPECT_EQ(played.quit().code, 0);
}

glm::uvec2 size_of(const Png& png) {
  const auto number = [&](size_t at) {  // of the header, most significant byte first
    uint32_t value = 0;
    for (size_t k = at; k < at + 4; ++k) value = value << 8 | static_cast<uint8_t>(png.bytes.at(k));
    return value;
  };
  return {number(16), number(20)};
}

TEST(Play, TheWindowMayHaveAnySize) {
  Played played({"breaking_dam", "--steps", "0"});
  for (const glm::uvec2 size : {glm::uvec2(900, 500), {120, 80}, {5, 3}, {400, 600}}) {
    played.resize(size.x, size.y);
    EXPECT_EQ(size_of(played.screenshot().png), glm::max(size, 16u)) << size.x << " x " << size.y;
  }
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, StartingAgainKeepsWhatWasChosen) {
  Played played({"breaking_dam", "--steps", "0"});
  played.press({"minus", "minus", "r"});
  played.wait_for("sluice: from the start, dt 0.0256\n");
  played.press({"bracketright"});
  played.wait_for("sluice: spacing 6.4, dt 0.02048, ");
  played.press({"plus", "r", "plus", "r", "bracketleft"});
  played.wait_for("sluice: from the start, dt 0.032\n");
  played.wait_for("sluice: spacing 8, dt 0.04, ");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, WhatTheMachineHasNoRoomForIsRefused) {
  const ProgramResult result = run_program({"play", "breaking_dam", "--set", "particles.spacing=0.001"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("particles.spacing"), std::string::npos) << result.err;
}

TEST(Play, AFileThatWasBrokenMeanwhileIsToldAndTheRunKept) {
  const TemporaryFolder folder;
  const std::string scene = folder / "a.toml",
                    text = read_file(std::string(SLUICE_SOURCE_DIR) + "/scenes/breaking_dam.toml");
  { std::ofstream(scene) << text; }
  Played played({scene, "--steps", "0"});
  played.press({"Right", "Right"});
  { std::ofstream(scene) << text << "broken"; }
  played.press({"r"});
  played.wait_for("a.toml:");
  EXPECT_EQ(played.screenshot().name, "a_000002.png");
  { std::ofstream(scene) << text; }
  played.press({"r"});
  played.wait_for("from the start");
  EXPECT_EQ(played.screenshot().name, "a_000000.png");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, AScreenshotThatCannotBeWrittenIsTold) {
  Played played({"breaking_dam", "--steps", "0"});
  std::filesystem::remove(played.folder.path);  // with nowhere to write to
  played.press({"s"});
  played.wait_for("cannot write breaking_dam_000000.png");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, ATimeStepStaysWithinReason) {
  Played played({"breaking_dam", "--steps", "0"});
  for (int k = 0; k < 31; ++k) played.press({"minus"});
  played.wait_for("sluice: dt stays ");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, HelpCoversThePictureAndGoesAway) {
  Played played({"breaking_dam", "--steps", "0", "--overlay", "none"});
  const Png plain = played.screenshot().png;
  played.press({"h"});
  EXPECT_NE(played.screenshot().png, plain);
  played.press({"h"});
  EXPECT_EQ(played.screenshot().png, plain);
  played.press({"h", "Escape"});
  EXPECT_EQ(played.screenshot().png, plain);
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, AnInvalidRunIsPausedAndSaysWhy) {
  Played played({"wcsph_box", "--set", "time.dt=0.0045", "--speed", "100"});
  const std::string reason = played.wait_for("sluice: invalid run: ");
  EXPECT_NE(reason.find("spacings in one step"), std::string::npos) << reason;
  EXPECT_NE(reason.find("a smaller time.dt often helps"), std::string::npos) << reason;
  played.expect_title("Block of water in a box – WCSPH (paused) – Sluice");
  played.press({"space"});
  played.wait_for("the run is invalid");
  played.press({"Right"});
  EXPECT_EQ(played.screenshot().name.substr(0, 10), "wcsph_box_");
  played.press({"r"});
  played.wait_for("sluice: invalid run: ");
  played.press({"minus"});
  played.wait_for("from the start, dt 0.0036");
  played.expect_title("Block of water in a box – WCSPH – Sluice");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, SaysWhatASceneLacks) {
  Played played({std::string(SLUICE_SOURCE_DIR) + "/tests/data/iisph_only.toml", "--steps", "0"});
  played.press({"1"});
  played.wait_for(
      "this scene has no [pressure.ssph]; add that table with a stiffness to its file to use SSPH");
  played.press({"3"});
  played.wait_for("this scene has no [pressure.wcsph]; add that table with a kappa to its file to use WCSPH");
  played.expect_title("A drop – IISPH (paused) – Sluice");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, WithoutASceneTheScenesAreShownToChooseFrom) {
  Played played({});
  played.expect_title("Sluice – choose a scene by its number or with the mouse");
  played.press({"s"});  // nothing to save here, and nothing later either
  for (const uint32_t size : {8u, 50u, 2000u, 900u}) played.resize(size, size);
  played.press({"5"});
  played.wait_for("backend: ");
  played.press({"space"});
  played.wait_for("paused at step ");
  played.expect_title("Leaking dam – IISPH (paused) – Sluice");
  EXPECT_TRUE(std::filesystem::is_empty(played.folder.path));
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, AChangeThatDoesNotFitASceneLeadsBackToTheList) {
  Played played({"--set", "pressure.method=ssph", "--set", "pressure.ssph={dt=0.1}"});
  played.press({"1"});
  played.wait_for("pressure.ssph.stiffness");
  played.expect_title("Sluice – choose a scene by its number or with the mouse");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, ATimeStepBeyondALimitIsWarnedOf) {
  Played played({"breaking_dam", "--steps", "0", "--set", "time.dt=0.15"});
  played.press({"plus"});
  EXPECT_NE(played.wait_for("sluice: dt 0.1875; ").find("above the limit of an explicit viscosity"),
            std::string::npos);
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, ASceneIsChosenWithTheMouseToo) {
  Played played({});
  played.expect_title("Sluice – choose a scene by its number or with the mouse");
  played.xdotool("mousemove 900 300 click 1");  // the last of the second row
  played.expect_title("Resting fluid – IISPH – Sluice");
  EXPECT_EQ(played.quit().code, 0);
}

TEST(Play, WithoutADisplaySaysSo) {
  RunningProgram program({"play", "breaking_dam"}, {.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}});
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(result.err.starts_with("sluice: a window needs a display: ")) << result.err;
  EXPECT_NE(result.err.find("`sluice run SCENE --video FILE.mp4`"), std::string::npos) << result.err;
}

TEST(Play, WithoutGlfwNamesThePackage) {
  const TemporaryFolder folder;
  { std::ofstream(folder / "libglfw.so.3"); }  // no library
  RunningProgram program({"play", "breaking_dam"},
                         {.environment = {"LD_LIBRARY_PATH=" + folder.path.string()}});
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.err,
            "sluice: a window needs libglfw.so.3, which cannot be loaded; install the package libglfw3\n");
}

TEST(Play, ASceneThatCannotBeReadNeedsNoWindowToSaySo) {
  const ProgramResult result = run_program({"play", "no_such_scene"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("no_such_scene: found no such file"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sluice::test
