// What becomes of a video when ffmpeg is not there, gives up or is not waited for, or its place can't be
// written.
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <random>

#include "tests/support/video_test.hpp"

namespace sluice::test {
namespace {

using FailedVideo = VideoTest;

TEST_F(FailedVideo, WithoutFinishNothingIsLeft) {
  std::ofstream(folder / "run.mp4") << "old";
  {
    media::VideoFile video(folder / "run.mp4", {320, 200}, 25);
    for (int k = 0; k < 20; ++k) video.write(quarters({320, 200}, {red, green, blue, grey}));
    EXPECT_TRUE(has_children());
  }
  EXPECT_FALSE(has_children());
  EXPECT_EQ(read_file(folder / "run.mp4"), "old");
  EXPECT_EQ(entries(folder.path), 1u);
}

TEST_F(FailedVideo, WithoutFinishNothingIsWaitedFor) {
  stand_in("sleep 60");
  const auto start = std::chrono::steady_clock::now();
  { const media::VideoFile video(folder / "out/run.mp4", {64, 64}, 25); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(entries(folder / "out"), 0u);
}

TEST_F(FailedVideo, OnlyFilesThatEndInMp4) {
  const auto make = [](const fs::path& name) {
    return message_of<InputError>([&] { media::VideoFile(name, {64, 64}, 25); });
  };
  for (const std::string name : {"run.avi", "run", "mp4", ".mp4", ""})
    EXPECT_TRUE(contains(make(name), name + ": expected a name that ends in .mp4")) << make(name);
  EXPECT_TRUE(contains(make("/dev/stdout"), "/dev/stdout: ")) << make("/dev/stdout");
  ASSERT_EQ(mkfifo((folder / "pipe.mp4").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "null.mp4");
  for (const std::string name : {"pipe.mp4", "null.mp4"})
    EXPECT_TRUE(contains(make(folder / name), name + ": found a device or a pipe, expected a file"))
        << make(folder / name);
}

TEST_F(FailedVideo, APlaceThatCannotBeWrittenIsReported) {
  const auto make = [](const fs::path& name) {
    return message_of([&] { media::VideoFile(name, {64, 64}, 25); });
  };
  fs::create_directory(folder / "folder.mp4");
  EXPECT_TRUE(contains(make(folder / "nowhere/run.mp4"), "create its folder"))
      << make(folder / "nowhere/run.mp4");
  EXPECT_TRUE(contains(make(folder / "folder.mp4"), "name a file, not a folder"));
}

TEST_F(FailedVideo, WithoutFfmpegThePackageIsNamed) {
  setenv("PATH", folder.path.c_str(), 1);
  const std::string message = message_of([&] { media::VideoFile(folder / "run.mp4", {64, 64}, 25); });
  EXPECT_EQ(message, (folder / "run.mp4").string() +
                         ": a video needs ffmpeg, which is not installed; install the package ffmpeg");
  EXPECT_EQ(entries(folder.path), 0u);
}

TEST_F(FailedVideo, WhatFfmpegSaysIsInTheErrorAndNoFileIsLeft) {
  stand_in("echo rubbish; echo 'Unknown encoder libx264' >&2; exit 1");
  const draw::Image image = quarters({640, 480}, {red, green, blue, grey});
  media::VideoFile video(folder / "out/run.mp4", {640, 480}, 25);
  // Some pictures may be on their way before it is gone; writing to it must not end this process.
  const auto write_all = [&] {
    for (int k = 0; k < 100; ++k) video.write(image);
  };
  const std::string message = message_of(write_all);
  EXPECT_EQ(message,
            "cannot write " + (folder / "out/run.mp4").string() +
                ": ffmpeg gave up with code 1: Unknown encoder libx264; check that there is space and that "
                "this ffmpeg has the encoder libx264");
  EXPECT_FALSE(has_children());
  EXPECT_EQ(entries(folder / "out"), 0u);
  EXPECT_EQ(message_of(write_all), message);
  EXPECT_EQ(message_of([&] { video.finish(); }), message);
}

TEST_F(FailedVideo, AFailureAtTheEndIsOneToo) {
  stand_in("cat >/dev/null; echo whole >\"$target\"; printf 'first\\nNo space left\\n\\n' >&2; exit 7");
  media::VideoFile video(folder / "out/run.mp4", {64, 64}, 25);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  const std::string message = message_of([&] { video.finish(); });
  EXPECT_TRUE(contains(message, "gave up with code 7: first\nNo space left; check")) << message;
  EXPECT_EQ(entries(folder / "out"), 0u);
}

TEST_F(FailedVideo, BeingKilledIsAFailure) {
  stand_in("cat >/dev/null; kill -KILL $$");
  media::VideoFile video(folder / "out/run.mp4", {64, 64}, 25);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  const std::string message = message_of([&] { video.finish(); });
  EXPECT_TRUE(contains(message, "was ended by signal 9: it said nothing; check")) << message;
  EXPECT_EQ(entries(folder / "out"), 0u);
}

TEST_F(FailedVideo, OfMuchTextTheEndIsShown) {
  stand_in("cat >/dev/null; head -c 100000 /dev/zero | tr '\\0' x >&2; echo the reason >&2; exit 1");
  media::VideoFile video(folder / "out/run.mp4", {64, 64}, 25);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  const std::string message = message_of([&] { video.finish(); });
  EXPECT_TRUE(contains(message, "the reason; check"));
  EXPECT_LT(message.size(), 2500u);
}

TEST_F(FailedVideo, ASizeThatFfmpegRefusesIsReported) {
  media::VideoFile video(folder / "run.mp4", {1, 100'000}, 25);  // beyond what H.264 takes
  const auto write_and_finish = [&] {
    video.write(quarters({1, 100'000}, {red, green, blue, grey}));
    video.finish();
  };
  const std::string message = message_of(write_and_finish);
  EXPECT_TRUE(contains(message, "cannot write " + (folder / "run.mp4").string() + ": ffmpeg gave up"))
      << message;
  EXPECT_EQ(entries(folder.path), 0u);
}

/// A video of noise while no file may become longer than `limit`, which stands for a full disk.
void write_noise(const fs::path& file, rlim_t limit) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit lower{limit, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &lower);
  std::mt19937 random(1);
  try {
    media::VideoFile video(file, {64, 64}, 25);
    setrlimit(RLIMIT_FSIZE, &before);
    for (int k = 0; k < 20; ++k) {
      draw::Image image{64, 64, {}};
      for (int i = 0; i < 64 * 64 * 3; ++i) image.rgb.push_back(static_cast<uint8_t>(random() % 256));
      video.write(image);
    }
    video.finish();
  } catch (const EnvironmentError&) {
    setrlimit(RLIMIT_FSIZE, &before);
    throw;
  }
}

TEST_F(FailedVideo, AFullDiskIsReportedAndLeavesNoFile) {
  write_noise(folder / "whole.mp4", RLIM_INFINITY);
  const auto size = fs::file_size(folder / "whole.mp4");
  fs::remove(folder / "whole.mp4");
  ASSERT_GT(size, 10'000u);
  // The last byte is missing; the index does not fit; half of it does not; nothing does.
  for (const auto limit : {size - 1, size - 1000, size / 2, size - size}) {
    const std::string message = message_of([&] { write_noise(folder / "run.mp4", limit); });
    EXPECT_TRUE(contains(message, "ffmpeg gave up with code")) << limit << ": " << message;
    EXPECT_EQ(entries(folder.path), 0u) << limit;
  }
}

TEST_F(FailedVideo, WhereNobodyCanAskHowFfmpegEndedItCountsAsFailed) {
  std::signal(SIGCHLD, SIG_IGN);
  const std::string message = message_of([&] {
    media::VideoFile video(folder / "run.mp4", {64, 64}, 25);
    video.write(quarters({64, 64}, {red, green, blue, grey}));
    video.finish();
  });
  std::signal(SIGCHLD, SIG_DFL);
  EXPECT_TRUE(contains(message, "ffmpeg gave up with code 255")) << message;
  EXPECT_EQ(entries(folder.path), 0u);
}

}  // namespace
}  // namespace sluice::test
