// Cases that are likely to go wrong come out as docs/hard_cases.md says, on both backends alike: those that
// take a moment. The others are in tests/long/.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/model/params.hpp"
#include "cpu/backend.hpp"
#include "sluice/load.hpp"
#include "tests/support/hard.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

using namespace study;
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

TEST(HardCaseTable, EveryCaseIsOnThePageWithWhatIsExpected) {
  const std::string page = read_file(SLUICE_SOURCE_DIR "/docs/results/hard_cases.md");
  for (const HardCase& hard : hard_cases()) {
    for (const char* backend : {"cpu", "gpu"}) {
      const std::string row = fmt::format("\n| {} | {} | {} | ", hard.name, hard.method, backend);
      const size_t start = page.find(row);
      ASSERT_NE(start, std::string::npos) << row;
      const std::string rest = page.substr(start + 1, page.find('\n', start + 1) - start - 1);
      EXPECT_TRUE(rest.ends_with(fmt::format("| {} | as expected |", text_of(hard.expected)))) << rest;
    }
  }
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

/// The case of this name.
HardCase named(const std::string& name) {
  for (HardCase& hard : hard_cases()) {
    if (hard.name == name) return hard;
  }
  throw std::runtime_error(name);
}

/// What the case starts from, in double.
std::vector<Vec2> start_of(const HardCase& hard) {
  const Scene scene = parse_scene(hard.scene, hard.name + ".toml");
  Samples samples = sample(scene);
  hard.rearrange(scene, samples);
  return samples.fluid;
}

TEST(HardCaseTable, PairsStartAsCloseAsTheirNamesSay) {
  for (const auto& [name, distance] :
       {std::pair{"0", 0.0}, {"1e12th", 1e-12}, {"1e6th", 1e-6}, {"1e3rd", 1e-3}})
    EXPECT_NEAR(closest_distance(start_of(named(fmt::format("pairs_at_{}_iisph", name)))), distance * h,
                1e-13 * h);
}

TEST(HardCaseTable, ParticlesOnCellEdgesAreThere) {
  const HardCase hard = named("on_cell_edges_iisph");
  const double half = 0.5 / make_params(parse_scene(hard.scene, "edges.toml"), 1).inverse_cell;
  for (const Vec2 x : start_of(hard)) {
    EXPECT_EQ(x.x / half, std::round(x.x / half));
    EXPECT_EQ(x.y / half, std::round(x.y / half));
  }
}

TEST(HardCaseTable, ARunStartsAsRearranged) {
  HardCase hard = named("pairs_at_0_iisph");
  hard.rearrange = [](const Scene&, Samples& samples) { samples.fluid[0].x = -1; };
  EXPECT_GE(run_case(hard, *cpu::make_backend(Precision::single_, 1)).statistics.lost(), 1u);
}

TEST(HardCaseTable, AListThatGrowsIsSeenToGrow) {
  const CaseResult result =
      run_case(named("crowd_of_19881_in_20_ssph"), *cpu::make_backend(Precision::single_, 2));
  EXPECT_GT(result.list_growths, 0u);
}

}  // namespace
}  // namespace sluice::test
