// Videos, looked at with ffprobe and decoded again with ffmpeg, and how ffmpeg is run.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <sstream>
#include <thread>

#include "tests/support/video_test.hpp"

namespace sluice::test {
namespace {

using Video = VideoTest;

/// What a shell command prints; its failure is the test's.
std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no shell");
  std::string text;
  char part[4096];
  for (size_t count; (count = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, count);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

/// One value of the video stream, as ffprobe prints it.
std::string probe(const fs::path& path, const std::string& entry) {
  const std::string text =
      output_of("ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entry +
                " -of csv=p=0 '" + path.string() + "'");
  return text.substr(0, text.find_first_of(",\n"));
}

/// The pictures of a video, all behind each other.
std::string decoded(const fs::path& path) {
  return output_of("ffmpeg -nostdin -v error -i '" + path.string() + "' -f rawvideo -pix_fmt rgb24 -");
}

/// The middle of each area in picture `index` of decoded bytes whose pictures are `size`.
void expect_quarters(const std::string& bytes, glm::uvec2 size, size_t index,
                     const std::array<Colour, 4>& colours) {
  ASSERT_GE(bytes.size(), size_t{3} * size.x * size.y * (index + 1));
  for (size_t part = 0; part < 4; ++part) {
    const size_t x = size.x / 4 + part % 2 * (size.x / 2), y = size.y / 4 + part / 2 * (size.y / 2);
    const size_t at = 3 * ((index * size.y + y) * size.x + x);
    for (size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<uint8_t>(bytes[at + c]), colours[part][c], 3)
          << "area " << part << ", colour " << c;
  }
}

TEST_F(Video, HasEveryPictureInItsSizeAndRate) {
  const glm::uvec2 size(320, 200);
  media::VideoFile video(folder / "run.mp4", size, 25);
  for (uint32_t k = 0; k < 60; ++k) {
    const auto shade = static_cast<uint8_t>(4 * k);
    video.write(quarters(size, {red, Colour{shade, shade, shade}, blue, grey}));
  }
  EXPECT_EQ(video.count(), 60u);
  EXPECT_FALSE(fs::exists(folder / "run.mp4"));
  video.finish();
  video.finish();
  EXPECT_EQ(entries(folder.path), 1u);
  const fs::path file = folder / "run.mp4";
  EXPECT_EQ(probe(file, "nb_read_frames"), "60");
  EXPECT_EQ(probe(file, "width"), "320");
  EXPECT_EQ(probe(file, "height"), "200");
  EXPECT_EQ(probe(file, "r_frame_rate"), "25/1");
  EXPECT_EQ(probe(file, "avg_frame_rate"), "25/1");
  EXPECT_NEAR(std::stod(probe(file, "duration")), 2.4, 1e-6);
  EXPECT_EQ(probe(file, "codec_name"), "h264");
  EXPECT_EQ(probe(file, "pix_fmt"), "yuv420p");
}

TEST_F(Video, StartsWithItsIndexSoThatAPageCanPlayIt) {
  media::VideoFile video(folder / "run.mp4", {64, 64}, 25);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  video.finish();
  const std::string bytes = read_file(folder / "run.mp4");
  EXPECT_EQ(bytes.substr(4, 4), "ftyp");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST_F(Video, KeepsColoursAndPlaces) {
  const glm::uvec2 size(160, 128);
  const std::array<Colour, 4> first{red, green, blue, grey},
      last{Colour{0, 0, 0}, blue, Colour{255, 255, 255}, red};
  media::VideoFile video(folder / "run.mp4", size, 30);
  for (int k = 0; k < 10; ++k) video.write(quarters(size, first));
  for (int k = 0; k < 10; ++k) video.write(quarters(size, last));
  video.finish();
  const std::string bytes = decoded(folder / "run.mp4");
  EXPECT_EQ(bytes.size(), size_t{3} * 160 * 128 * 20);
  expect_quarters(bytes, size, 0, first);
  expect_quarters(bytes, size, 19, last);
  for (const char* entry : {"color_space", "color_primaries", "color_transfer"})
    EXPECT_EQ(probe(folder / "run.mp4", entry), "bt709") << entry;
  EXPECT_EQ(probe(folder / "run.mp4", "color_range"), "tv");
}

TEST_F(Video, OddSizesGetAWhiteEdge) {
  const glm::uvec2 size(161, 127);
  const std::array<Colour, 4> colours{red, green, blue, grey};
  media::VideoFile video(folder / "run.mp4", size, 30);
  video.write(quarters(size, colours));
  video.finish();
  EXPECT_EQ(probe(folder / "run.mp4", "width"), "162");
  EXPECT_EQ(probe(folder / "run.mp4", "height"), "128");
  const std::string bytes = decoded(folder / "run.mp4");
  ASSERT_EQ(bytes.size(), size_t{3} * 162 * 128);
  expect_quarters(bytes, {162, 128}, 0, colours);
  const size_t below = 3 * (size_t{127} * 162 + 120);  // under the grey area
  for (size_t c = 0; c < 3; ++c) EXPECT_GT(static_cast<uint8_t>(bytes[below + c]), 235);
}

TEST_F(Video, RatesAreTheRatiosThatWereMeant) {
  for (const auto& [rate, ratio] : {std::pair{12.5, "25/2"},
                                    {1000.0 / 3, "1000/3"},
                                    {30000.0 / 1001, "30000/1001"},
                                    {0.1, "1/10"},
                                    {1.0, "1/1"},
                                    {240.0, "240/1"}}) {
    media::VideoFile video(folder / "run.mp4", {64, 64}, rate);
    for (int k = 0; k < 7; ++k) video.write(quarters({64, 64}, {red, green, blue, grey}));
    video.finish();
    EXPECT_EQ(probe(folder / "run.mp4", "r_frame_rate"), ratio);
    EXPECT_EQ(probe(folder / "run.mp4", "nb_read_frames"), "7") << ratio;
    EXPECT_NEAR(std::stod(probe(folder / "run.mp4", "duration")), 7 / rate, 1e-4 / rate + 1e-6) << ratio;
  }
}

TEST_F(Video, ReplacesAnOldFileOnlyWhenItIsWhole) {
  std::ofstream(folder / "run: 50%.mp4") << "old";
  media::VideoFile video(folder / "run: 50%.mp4", {64, 64}, 25);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  EXPECT_EQ(read_file(folder / "run: 50%.mp4"), "old");
  video.finish();
  EXPECT_EQ(probe(folder / "run: 50%.mp4", "nb_read_frames"), "1");
  EXPECT_EQ(entries(folder.path), 1u);
}

TEST_F(Video, ARelativeNameWorksAnywhere) {
  const fs::path before = fs::current_path();
  fs::current_path(folder.path);
  fs::create_directory("http:");  // which must not be taken for an address
  for (const char* name : {"-y.mp4", "http:/run.mp4"}) {
    media::VideoFile video(name, {64, 64}, 25);
    video.write(quarters({64, 64}, {red, green, blue, grey}));
    EXPECT_EQ(message_of([&] { video.finish(); }), "no such error");
  }
  fs::current_path(before);
  EXPECT_EQ(probe(folder / "-y.mp4", "nb_read_frames"), "1");
  EXPECT_EQ(probe(folder / "http:/run.mp4", "nb_read_frames"), "1");
}

TEST_F(Video, WithoutAPictureThereIsNoFile) {
  media::VideoFile video(folder / "run.mp4", {64, 64}, 25);
  video.finish();
  EXPECT_FALSE(has_children());
  EXPECT_EQ(entries(folder.path), 0u);
}

TEST_F(Video, NothingIsWrittenAfterwards) {
  const draw::Image image = quarters({64, 64}, {red, green, blue, grey});
  media::VideoFile video(folder / "run.mp4", {64, 64}, 25);
  video.write(image);
  EXPECT_THROW(video.write(quarters({64, 63}, {red, green, blue, grey})), Error);
  EXPECT_THROW(video.write(draw::Image{64, 64, {1, 2, 3}}), Error);
  video.finish();
  EXPECT_THROW(video.write(image), Error);
  EXPECT_EQ(probe(folder / "run.mp4", "nb_read_frames"), "1");
}

TEST_F(Video, CtrlCOfTheTerminalPassesItBy) {
  stand_in(
      "read -r pid name state parent group rest </proc/$$/stat\n"
      "[ $group = $$ ] && echo own >" +
      (folder / "group").string() +
      "\n"
      "grep SigIgn /proc/$$/status >" +
      (folder / "ignored").string() + "\ncat >/dev/null");
  std::signal(SIGPIPE, SIG_IGN);
  media::VideoFile video(folder / "out/run.mp4", {64, 64}, 25);
  std::signal(SIGPIPE, SIG_DFL);
  video.write(quarters({64, 64}, {red, green, blue, grey}));
  video.finish();
  EXPECT_TRUE(fs::exists(folder / "group"));
  std::istringstream words(read_file(folder / "ignored"));
  std::string name, mask;
  words >> name >> mask;
  EXPECT_EQ(std::stoull(mask, nullptr, 16) >> (SIGPIPE - 1) & 1u, 0u) << mask;
}

TEST_F(Video, TwoVideosDoNotWaitForEachOther) {
  const draw::Image image = quarters({64, 64}, {red, green, blue, grey});
  auto first = std::make_unique<media::VideoFile>(folder / "first.mp4", glm::uvec2(64, 64), 25);
  media::VideoFile second(folder / "second.mp4", {64, 64}, 25);
  first->write(image);
  second.write(image);
  first->finish();  // would wait for ever if the second ffmpeg held the first one's input open
  second.finish();
  EXPECT_EQ(probe(folder / "first.mp4", "nb_read_frames"), "1");
  EXPECT_EQ(probe(folder / "second.mp4", "nb_read_frames"), "1");
}

TEST_F(Video, ASlowFfmpegHoldsTheCallerUpAndGetsEveryByte) {
  const std::string go = folder / "go", length = folder / "length";
  stand_in("while [ ! -e " + go + " ]; do sleep 0.01; done; wc -c >" + length);
  struct sigaction action {};
  action.sa_handler = [](int) {};
  sigaction(SIGUSR1, &action, nullptr);
  const draw::Image image = quarters({640, 480}, {red, green, blue, grey});
  media::VideoFile video(folder / "out/run.mp4", {640, 480}, 25);
  std::thread writer([&] {
    for (int k = 0; k < 3; ++k) video.write(image);
    std::ofstream(folder / "written") << "";
  });
  // Signals interrupt the waiting, in the midst of a picture too.
  for (int k = 0; k < 20; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    pthread_kill(writer.native_handle(), SIGUSR1);
  }
  EXPECT_FALSE(fs::exists(folder / "written"));
  std::ofstream(go) << "";
  writer.join();
  EXPECT_EQ(video.count(), 3u);
  video.finish();
  EXPECT_EQ(std::stoul(read_file(length)), 3u * 640 * 480 * 3);
  EXPECT_TRUE(fs::exists(folder / "out/run.mp4"));
}

}  // namespace
}  // namespace sluice::test
