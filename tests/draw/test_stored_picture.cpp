// A picture of the breaking dam at time 6, when the wave has just reached the right wall, as it was stored:
// physics and drawing together. Graphics drivers differ a little in how they smooth edges, so a few pixels
// may differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

constexpr const char* stored = SLUICE_SOURCE_DIR "/tests/data/breaking_dam_t6.png";
constexpr const char* words =
    "run breaking_dam --backend cpu --threads 1 --precision double --time 6 --fps 0.1666666667 --size "
    "200x300 --overlay "
    "none";

/// Share of the pixels of two pictures of one size that differ by more than 16 levels in a channel.
double share_apart(const draw::Image& a, const draw::Image& b) {
  size_t apart = 0;
  for (size_t at = 0; at < a.rgb.size(); at += 3) {
    int most = 0;
    for (size_t k = at; k < at + 3; ++k) most = std::max(most, std::abs(a.rgb[k] - b.rgb[k]));
    apart += most > 16 ? 1u : 0u;
  }
  return static_cast<double>(apart) / (a.width * a.height);
}

/// Draws the picture anew, with further words; empty when that fails.
draw::Image drawn(const std::string& more = "") {
  const TemporaryFolder folder;
  const std::string command =
      std::string(SLUICE_BINARY) + ' ' + words + ' ' + more + " --quiet --frames " + folder.path.string();
  if (std::system(command.c_str()) != 0) return {};
  return read_image(folder / "frame_000001.png");
}

TEST(StoredPicture, IsDrawnAgain) {
  const std::string again =
      "build/release/sluice " + std::string(words) +
      " --frames build/stored && cp build/stored/frame_000001.png tests/data/breaking_dam_t6.png";
  const draw::Image expected = read_image(stored), found = drawn();
  ASSERT_EQ(found.width, expected.width) << again;
  ASSERT_EQ(found.height, expected.height) << again;
  EXPECT_LT(share_apart(expected, found), 0.005)
      << "The picture has changed. Look at both; if the change is meant, store the new one:\n"
      << again;
}

// What the comparison must not let pass: other physics, another drawing.
TEST(StoredPicture, ASmallChangeIsSeen) {
  const draw::Image expected = read_image(stored);
  for (const char* change : {"--set viscosity.coefficient=201", "--set pressure.iisph.tolerance=1.1e-3",
                             "--set fluid.gravity=[0,-9.8]", "--set time.dt=0.0401", "--colour density",
                             "--set domain.max=[401,601]"}) {
    const draw::Image found = drawn(change);
    ASSERT_EQ(found.rgb.size(), expected.rgb.size()) << change;
    EXPECT_GT(share_apart(expected, found), 0.005) << change;
  }
}

}  // namespace
}  // namespace sluice::test
