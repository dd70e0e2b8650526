// `--video` of a run and of a recording: length, size and rate as ffprobe sees them, and nothing else when it
// fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
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
  while (program.running() && std::filesystem::is_empty(folder.path))  // then it listens to signals
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(probe(film).starts_with("h264,200,900,25/1,")) << probe(film);
}

TEST(CliVideo, ASecondCtrlCDoesNotWaitForAnFfmpegThatHangs) {
  const TemporaryFolder folder;
  {
    std::ofstream script(folder / "ffmpeg");
    script << "#!/bin/sh\nexec sleep 60\n";
  }
  std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
  RunningProgram program(
      {"run", "leaking_dam", "--backend", "cpu", "--time", "1e4", "--quiet", "--video", folder / "film.mp4"},
      {.environment = {fmt::format("PATH={}:/usr/bin:/bin", folder.path.string())}});
  const auto temporary = [&] {
    return std::ranges::any_of(std::filesystem::directory_iterator(folder.path), [](const auto& entry) {
      return entry.path().filename().string().starts_with(".sluice");
    });
  };
  while (program.running() && !temporary()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // it waits for ffmpeg by now
  program.send(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_TRUE(program.running());
  program.send(SIGINT);
  EXPECT_EQ(program.wait().code, 128 + SIGINT);
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
}

/// Rates and sizes with which ffmpeg, left to itself, chooses another rate.
TEST(CliVideo, HighRatesKeepEveryPicture) {
  const TemporaryFolder folder;
  const std::string film = folder / "film.mp4";
  for (const auto& [fps, rate] : {std::pair{"250", "250/1"}, {"241", "241/1"}, {"121", "121/1"}}) {
    ASSERT_EQ(run_program({"run", "breaking_dam", "--time", "2", "--set", "time.dt=0.004", "--fps", fps,
                           "--size", "800x480", "--quiet", "--video", film})
                  .code,
              0);
    const std::string found = probe(film), frames = std::to_string(2 * std::stoi(fps) + 1);
    EXPECT_TRUE(found.starts_with(fmt::format("h264,800,480,{},", rate))) << found;
    EXPECT_TRUE(found.ends_with(fmt::format(",{}\n", frames))) << found;
  }
}

TEST(CliVideo, SpeedWithoutAFilmIsWarnedOf) {
  const ProgramResult result = run_program({"run", "inclined_plane", "--steps", "1", "--speed", "2"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("--speed has no effect without --video"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sluice::test
