// Pictures of a run: which there are, of which steps, and what the options change.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

/// The frames of breaking_dam (dt 0.04) with these words, as bytes.
std::vector<std::string> frames(const Words& more) {
  const TemporaryFolder folder;
  Words words{"run", "breaking_dam", "--threads", "1", "--quiet", "--frames", folder / "new/frames"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.code, 0) << result.err;
  std::vector<std::string> pictures;
  for (const std::string& name : names_in(folder / "new/frames")) {
    char expected[40];
    std::snprintf(expected, sizeof expected, "frame_%06zu.png", pictures.size());
    EXPECT_EQ(name, expected);
    pictures.push_back(read_file(folder / ("new/frames/" + name)));
  }
  return pictures;
}

const Words small{"--size", "120x180"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(CliFrames, TheFirstIsTheStart) {
  const auto start = frames(with(small, {"--steps", "0"}));
  ASSERT_EQ(start.size(), 1u);
  EXPECT_TRUE(frames(with(small, {"--steps", "1"})).front() == start.front());
}

TEST(CliFrames, AreDueAtTheFirstStepThatReachesTheirTime) {
  const auto every = frames(with(small, {"--steps", "6", "--fps", "25"}));  // one per step
  ASSERT_EQ(every.size(), 7u);
  for (size_t k = 1; k < every.size(); ++k) EXPECT_FALSE(every[k] == every[k - 1]) << k;

  const auto rarer =
      frames(with(small, {"--steps", "6", "--fps", "10"}));  // 0.1 is passed by step 3, 0.2 met by 5
  ASSERT_EQ(rarer.size(), 3u);
  EXPECT_TRUE(rarer[0] == every[0]);
  EXPECT_TRUE(rarer[1] == every[3]);
  EXPECT_TRUE(rarer[2] == every[5]);

  const auto denser =
      frames(with(small, {"--steps", "2", "--fps", "80"}));  // 0.0125, 0.025, 0.0375; 0.05 ... 0.075
  ASSERT_EQ(denser.size(), 7u);
  for (size_t k = 1; k < denser.size(); ++k) EXPECT_TRUE(denser[k] == every[k <= 3 ? 1 : 2]) << k;

  EXPECT_EQ(frames(with(small, {"--steps", "6", "--fps", "4"})).size(), 1u);  // 0.25 is not reached
  EXPECT_EQ(frames(with(small, {"--steps", "50", "--fps", "0.5"})).size(), 2u);
  // Three times 0.15 is less than 9/20, but only by a rounding.
  EXPECT_EQ(frames(with(small, {"--steps", "3", "--set", "time.dt=0.15", "--fps", "20"})).size(), 10u);
  EXPECT_EQ(frames(with(small, {"--steps", "2", "--set", "output.fps=50"})).size(), 5u);
}

TEST(CliFrames, HaveTheirSize) {
  const TemporaryFolder folder;
  const auto size = [&](const Words& more) {
    Words words{"run", "breaking_dam", "--steps", "0", "--quiet", "--frames", folder.path};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(words).code, 0);
    const draw::Image image = read_image(folder / "frame_000000.png");
    return std::pair(image.width, image.height);
  };
  EXPECT_EQ(size({}), std::pair(400u, 600u));
  EXPECT_EQ(size({"--size", "123x77"}), std::pair(123u, 77u));
  EXPECT_EQ(size({"--set", "output.size=[90, 60]"}), std::pair(90u, 60u));
}

TEST(CliFrames, ColoursDiffer) {
  const auto last = [](const std::string& colour) {
    return frames(with(small, {"--steps", "20", "--fps", "1.25", "--overlay", "none", "--colour", colour}))
        .back();
  };
  const std::string speed = last("speed"), density = last("density"), pressure = last("pressure");
  EXPECT_FALSE(speed == density);
  EXPECT_FALSE(density == pressure);
  EXPECT_FALSE(pressure == speed);
  EXPECT_TRUE(frames(with(small, {"--steps", "20", "--fps", "1.25", "--overlay", "none"})).back() == speed);
}

TEST(CliFrames, FactsHaveNoTimingAllHas) {
  const auto overlay = [](const Words& more) {
    return frames(with({"--size", "400x600", "--steps", "5"}, more));  // room for all lines
  };
  const auto none = overlay({"--overlay", "none"}), facts = overlay({"--overlay", "facts"}),
             all = overlay({"--overlay", "all"});
  ASSERT_EQ(facts.size(), 6u);
  for (size_t k = 0; k < facts.size(); ++k) {
    EXPECT_FALSE(none[k] == facts[k]) << k;
    EXPECT_FALSE(all[k] == facts[k]) << k;
  }
  EXPECT_TRUE(overlay({}) == facts) << "the default, and the same bytes in a second run";
  EXPECT_TRUE(overlay({"--overlay", "none"}) == none);
}

TEST(CliFrames, ShowTheFactsOfTheirStep) {
  // Without the particles' part of the picture two steps differ in time and iterations only.
  const Words words{"--size", "400x600", "--overlay", "facts", "--fps", "25"};
  const auto one = frames(with(words, {"--steps", "1"})),
             other = frames(with(words, {"--steps", "1", "--set", "scene.title=Other"}));
  EXPECT_FALSE(one[0] == other[0]) << "the title";
  const auto ssph =
      frames(with(words, {"--steps", "0", "--set", "pressure.method=ssph", "--set", "time.dt=0.04"}));
  EXPECT_FALSE(one[0] == ssph[0]) << "the method";
}

}  // namespace
}  // namespace sluice::test
