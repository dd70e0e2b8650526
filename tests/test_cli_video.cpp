// `--video` of a run and of a recording: length, size and rate as ffprobe sees them, and nothing else when it
// fails.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "tests/support/running_program.hpp"

namespace sluice::test {
namespace {

std::string probe(const std::string& file) {
  FILE* pipe = popen(("ffprobe -v error -select_streams v -show_entries "
                      "stream=codec_name,width,height,avg_frame_rate,nb_frames,duration -of csv=p=0 '" +
                      file + "'")
                         .c_str(),
                     "r");
  std::string text;
  char part[256];
  while (fgets(part, sizeof part, pipe) != nullptr) text += part;
  pclose(pipe);
  return text;
}

TEST(CliVideo, IsAsLongAndLargeAndFastAsTheRun) {
  const TemporaryFolder folder;
  const std::string film = folder / "film.mp4", recording = folder / "a.rec";
  const ProgramResult run =
      run_program({"run", "breaking_dam", "--time", "2", "--record", recording, "--video", film});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(probe(film), "h264,400,600,25/1,2.040000,51\n");
  EXPECT_NE(run.out.find("51 pictures, 2.04 seconds, in " + film), std::string::npos) << run.out;

  const ProgramResult slow = run_program(
      {"export", recording, "--video", folder / "slow.mp4", "--speed", "0.5", "--size", "201x301"});
  ASSERT_EQ(slow.code, 0) << slow.err;
  EXPECT_EQ(probe(folder / "slow.mp4"), "h264,202,302,25/2,4.080000,51\n");
}

TEST(CliVideo, WithoutFfmpegNamesThePackageBeforeTheFirstStep) {
  const TemporaryFolder folder;
  RunningProgram program({"run", "breaking_dam", "--backend", "cpu", "--quiet", "--video",
                          folder / "film.mp4", "--series", folder / "series.csv"},
                         {.environment = {"PATH=" + folder.path.string()}});
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 3);
  EXPECT_NE(result.err.find("install the package ffmpeg"), std::string::npos) << result.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(CliVideo, AnotherEndingIsRefused) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"run", "breaking_dam", "--steps", "1", "--video", folder / "film.avi"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("film.avi"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(".mp4"), std::string::npos) << result.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(CliVideo, AnInterruptedRunLeavesAFilmOfWhatThereWas) {
  const TemporaryFolder folder;
  const std::string film = folder / "film.mp4";
  RunningProgram program(
      {"run", "leaking_dam", "--backend", "cpu", "--time", "1e4", "--quiet", "--video", film});
  std::this_thread::sleep_for(std::chrono::seconds(2));
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(probe(film).starts_with("h264,200,900,25/1,")) << probe(film);
}

}  // namespace
}  // namespace sluice::test
