// `sluice play` of a recording: forwards, backwards, by single frames and by the bar, always with the
// pictures that the run itself draws.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/played.hpp"

namespace sluice::test {
namespace {

using Words = std::vector<std::string>;

/// A run of 20 steps and its 21 frames, one a step.
class PlayRecording : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramResult result = run_program({"run", "breaking_dam", "--steps", "20", "--quiet", "--overlay",
                                              "none", "--record", recording, "--frames", folder / "frames"});
    ASSERT_EQ(result.code, 0) << result.err;
  }
  Png frame(int k) const { return {read_file(folder / fmt::format("frames/frame_{:06}.png", k))}; }
  static std::string name(int k) { return fmt::format("breaking_dam_{:06}.png", k); }

  TemporaryFolder folder;
  std::string recording = folder / "a.rec";
};

TEST_F(PlayRecording, EveryFrameIsThePictureOfTheRun) {
  Played played({recording, "--overlay", "none", "--speed", "100"});
  played.wait_for("the end; space plays it again");
  played.expect_title("Breaking dam – IISPH (paused) – recording – Sluice");
  const auto shows = [&](int k) {
    const auto shot = played.screenshot();
    EXPECT_EQ(shot.name, name(k));
    EXPECT_EQ(shot.png, frame(k));
  };
  shows(20);
  played.press({"Left", "Left"});
  shows(18);
  played.press({"Home"});
  shows(0);
  played.press({"Left", "Right", "Right", "Right"});
  shows(3);
  played.press({"End"});
  EXPECT_EQ(played.screenshot().name, "breaking_dam_000020_2.png");
  played.press({"r"});
  played.wait_for("from the start");
  played.wait_for("the end");                      // it was no pause of the user's
  played.xdotool("key Left Left Left Left Left");  // all at once
  EXPECT_EQ(played.screenshot().name, name(15));
  EXPECT_EQ(played.quit().code, 0);
}

TEST_F(PlayRecording, RunsBackwardsAndAtAnySpeed) {
  Played played({recording, "--speed", "0.001"});
  played.press({"b"});
  played.wait_for("backwards");
  played.wait_for("the start");
  EXPECT_EQ(played.screenshot().name, name(0));
  played.press({"End", "Up", "Up"});
  played.wait_for("speed -0.002\n");
  played.wait_for("speed -0.004\n");
  played.press({"space"});
  EXPECT_EQ(played.wait_for("goes on at frame "), "21");
  for (int k = 0; k < 12; ++k) played.press({"Up"});
  played.wait_for("the start");
  EXPECT_EQ(played.screenshot().name, "breaking_dam_000000_2.png");
  played.press({"b"});
  played.wait_for("forwards");
  played.wait_for("the end");
  played.press({"Down"});
  played.wait_for("speed ");
  EXPECT_EQ(played.quit().code, 0);
}

TEST_F(PlayRecording, TheBarAtTheBottomScrubs) {
  Played played({recording, "--overlay", "all", "--speed", "0.001"});
  played.xdotool("mousemove 200 585 click 1");
  EXPECT_EQ(played.screenshot().name, name(10));
  played.xdotool("mousemove 200 585 mousedown 1 mousemove 390 585");
  played.press({"o"});  // takes the bar away
  played.xdotool("mousemove 30 585");
  EXPECT_EQ(played.screenshot().name, name(20));
  played.press({"o", "o"});
  played.xdotool("mouseup 1");
  EXPECT_EQ(played.screenshot().name, "breaking_dam_000020_2.png");
  played.xdotool("mousemove 200 300 mousedown 1 mousemove 100 585 mouseup 1");  // moves the picture
  EXPECT_EQ(played.screenshot().name, "breaking_dam_000020_3.png");
  EXPECT_EQ(played.quit().code, 0);
}

TEST_F(PlayRecording, SaysThatItCannotBeSimulatedOtherwise) {
  Played played({recording, "--speed", "0.001"});
  played.press({"1"});
  played.wait_for("this is a recording; `sluice play SCENE` simulates, with other choices");
  EXPECT_EQ(played.quit().code, 0);
  for (const Words& option : {Words{"--steps", "3"},
                              {"--time", "1"},
                              {"--backend", "cpu"},
                              {"--precision", "double"},
                              {"--set", "time.dt=1"}}) {
    const ProgramResult result = run_program({"play", recording, option[0], option[1]});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("found a recording with an option of runs"), std::string::npos) << result.err;
  }
}

TEST_F(PlayRecording, RefusesOneThatWasCutOffWithoutAWindow) {
  std::filesystem::resize_file(recording, std::filesystem::file_size(recording) / 2);
  const ProgramResult result = run_program({"play", recording});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(
      result.err.starts_with("sluice: " + recording + ": found a recording that was cut off or altered"))
      << result.err;
}

}  // namespace
}  // namespace sluice::test
