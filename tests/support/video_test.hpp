// What the tests of videos share: pictures of four colours, and a folder in which nothing may be left
// running.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "media/video.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

namespace fs = std::filesystem;
using Colour = std::array<uint8_t, 3>;

constexpr Colour red{230, 20, 20}, green{20, 200, 40}, blue{20, 40, 230}, grey{237, 237, 237};

/// Four areas of one colour each: top left, top right, bottom left, bottom right.
inline draw::Image quarters(glm::uvec2 size, const std::array<Colour, 4>& colours) {
  draw::Image image{size.x, size.y, {}};
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x)
      for (const uint8_t value : colours[(2 * y >= size.y ? 2u : 0u) + (2 * x >= size.x ? 1u : 0u)])
        image.rgb.push_back(value);
  return image;
}

inline size_t entries(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Whether this process has children, dead ones that nobody waited for included.
inline bool has_children() { return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

class VideoTest : public testing::Test {
 protected:
  // A test that waits for ever is ended by the alarm.
  void SetUp() override { alarm(60); }
  void TearDown() override {
    setenv("PATH", path.c_str(), 1);
    EXPECT_FALSE(has_children());
    alarm(0);
  }

  /// From now on `ffmpeg` is this shell script; the last word of its command line is `$target`.
  void stand_in(const std::string& script) {
    fs::create_directory(folder / "bin");
    std::ofstream(folder / "bin/ffmpeg") << "#!/bin/sh\nfor target; do :; done; target=${target#file:}\n"
                                         << script;
    fs::permissions(folder / "bin/ffmpeg", fs::perms(0755));
    setenv("PATH", ((folder / "bin").string() + ":" + path).c_str(), 1);
    fs::create_directory(folder / "out");
  }

  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
};

}  // namespace sluice::test
