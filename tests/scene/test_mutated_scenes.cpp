// Scene files and overrides that nobody would write are loaded or refused by name, and nothing else: 5000 of
// each kind, made from good ones by seeded changes. The long suite tries many more.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/scene/settings.hpp"
#include "sluice/load.hpp"
#include "tests/support/mutated_scenes.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/scene_claims.hpp"

namespace sluice::test {
namespace {

class MutatedScenes : public testing::TestWithParam<uint64_t> {};

TEST_P(MutatedScenes, AreLoadedOrRefused) { expect_claims_of_scenes({GetParam(), 1000}); }

TEST_P(MutatedScenes, OverridesAreTakenOrRefused) { expect_claims_of_overrides({GetParam(), 1000}); }

std::string seed_name(const testing::TestParamInfo<uint64_t>& info) {
  return fmt::format("From{}", info.param);
}
INSTANTIATE_TEST_SUITE_P(Seeds, MutatedScenes, testing::Values(0, 1000, 2000, 3000, 4000), seed_name);

// JSON has no number for what is not finite, so that such a one reads back as null.
TEST(MutatedScenesTest, WhatIsNotFiniteIsNamed) {
  Scene scene = load_scene("template");
  EXPECT_EQ(not_finite(scene), "");
  auto settings = settings_of(scene);
  settings["time"]["duration"] = std::numeric_limits<double>::infinity();
  scene.record.settings = settings.dump();
  EXPECT_EQ(not_finite(scene), "duration is not finite");
}

TEST(MutatedScenesTest, ASeedGivesTheSameFileEverywhere) {
  const std::vector<std::string> corpus{"[a]\nx = 1\n", "[b]\ny = 22\n"};
  std::string all;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    all += mutant(corpus, scene_mutations(), dice);
  }
  uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char c : all) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  EXPECT_EQ(hash, 9564992489733940651u);
}

}  // namespace
}  // namespace sluice::test
