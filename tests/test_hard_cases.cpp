// Cases that are likely to go wrong come out as docs/hard_cases.md says, on both backends alike: those that
// take a moment. The others are in tests/long/.
#include <algorithm>
#include <set>

#include "core/scene_file.hpp"
#include "tests/support/hard.hpp"

namespace sluice::test {
namespace {

class HardCases : public testing::TestWithParam<HardRun> {};

TEST_P(HardCases, ComeOutAsExpected) { expect_as_expected(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Quick, HardCases, testing::ValuesIn(hard_runs(true)),
                         [](const auto& row) { return row.param.name(); });

TEST(HardCaseTable, NamesAreFileNamesAndOnlyOnce) {
  std::set<std::string> names;
  for (const HardCase& hard : hard_cases()) {
    EXPECT_TRUE(names.insert(hard.name).second) << hard.name << " twice";
    EXPECT_TRUE(std::ranges::all_of(hard.name, [](unsigned char c) { return std::isalnum(c) || c == '_'; }))
        << hard.name;
  }
  EXPECT_GT(names.size(), 200u);
}

TEST(HardCaseTable, EveryStopAndRefusalSaysWhy) {
  for (const HardCase& hard : hard_cases()) {
    if (hard.expected.outcome == Outcome::survived && !hard.expected.may_be_stopped) continue;
    EXPECT_NE(hard.expected.reason, "") << hard.name;
  }
}

TEST(HardCaseTable, ScenesThatAreNotToBeRefusedParse) {
  for (const HardCase& hard : hard_cases()) {
    if (hard.expected.outcome == Outcome::refused) continue;
    EXPECT_NO_THROW(sample(parse_scene(hard.scene, hard.name + ".toml"))) << hard.name;
  }
}

}  // namespace
}  // namespace sluice::test
