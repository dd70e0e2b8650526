// From seeds to mutants of scenes to claims.
#include "tests/support/mutated_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "core/scene/keys.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scene_claims.hpp"

namespace sluice::test {
namespace {

constexpr double memory = 64e6;  // for as many particles as can be sampled in no time

void expect_claims(Seeds seeds, const std::function<Judgement(Dice&, std::string& shown)>& judge) {
  uint64_t loaded = 0, sampled = 0;
  for (uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
    Dice dice(seed);
    std::string shown;
    const Judgement judgement = judge(dice, shown);
    loaded += judgement.loaded;
    sampled += judgement.sampled;
    EXPECT_EQ(judgement.broken, "") << "seed " << seed << ":\n" << shown;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(sampled, seeds.count / 20);
  EXPECT_GT(loaded, sampled);
  EXPECT_LT(loaded, seeds.count / 2);
}

/// A value of the kind that the key takes, as TOML text.
std::string good_value(const SceneKey& key, Dice& dice) {
  switch (key.type) {
    case KeyType::text: return "\"text\"";
    case KeyType::number: return "0.75";
    case KeyType::integer: return "2";
    case KeyType::length: return "\"1+2h\"";
    case KeyType::numbers: return "[1, -2.5]";
    case KeyType::integers: return "[20, 17]";
    case KeyType::lengths: return "[\"5+10h\", 40]";
    case KeyType::matrix: return "[[0, 1], [2, 3]]";
    case KeyType::points: return "[[0, 0], [99, 0], [0, \"9h\"]]";
    case KeyType::choice: return std::string(dice.of(key.choices).name);
    case KeyType::table:
    case KeyType::tables: return "{}";
    case KeyType::choices: return fmt::format("[\"{}\"]", dice.of(key.choices).name);
  }
  return "";
}

/// "fluid.rect.0.min=[1e308, 40]" and the like.
std::string some_override(Dice& dice, std::span<const std::string> corpus) {
  const SceneKey& key = dice.of(scene_keys());
  std::string path(key.path), value = good_value(key, dice);
  if (const size_t array = path.find("[]"); array != path.npos)
    path.replace(array, 2, fmt::format(".{}", dice.below(dice.one_in(4) ? 3 : 1)));
  if (dice.one_in(2)) replace_number(value, dice, corpus);
  std::string text = fmt::format("{}={}", path, value);
  if (dice.one_in(3)) dice.of(byte_mutations())(text, dice, corpus);
  return text;
}

}  // namespace

std::vector<std::string> scene_corpus() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {SLUICE_SOURCE_DIR "/scenes", SLUICE_SOURCE_DIR "/tests/data"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const auto& file : files) texts.push_back(read_file(file));
  return texts;
}

void expect_claims_of_scenes(Seeds seeds) {
  const std::vector<std::string> corpus = scene_corpus();
  expect_claims(seeds, [&](Dice& dice, std::string& shown) {
    shown = mutant(corpus, scene_mutations(), dice);
    return judge_scene(shown, {}, memory, most_seconds);
  });
}

void expect_claims_of_overrides(Seeds seeds) {
  const std::vector<std::string> corpus = scene_corpus();
  expect_claims(seeds, [&](Dice& dice, std::string& shown) {
    std::vector<std::string> overrides;
    for (size_t n = 1 + dice.below(2); n > 0; --n) {
      overrides.push_back(some_override(dice, corpus));
      shown += fmt::format("--set '{}'\n", overrides.back());
    }
    return judge_scene(dice.of<std::string>(corpus), overrides, memory, most_seconds);
  });
}

}  // namespace sluice::test
