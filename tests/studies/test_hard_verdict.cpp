// What a hard case measures is what happened, and every bound on it can be missed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "cpu/backend.hpp"
#include "studies/hard_table.hpp"
#include "studies/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

CaseResult run_on_cpu(const HardCase& hard) {
  return run_case(hard, *cpu::make_backend(Precision::double_, 1));
}

/// Two particles, one above the other, thrown up where nothing is in their way.
SceneParts thrown() {
  SceneParts parts;
  parts.title = "Thrown";
  parts.size = {40 * h, 40 * h};
  parts.fluid = block({20 * h, 10 * h}, 1, 1, {0, 20}) + block({20 * h, 20 * h}, 1, 1, {0, 20});
  parts.time = fixed(0.125, 4);
  return parts;
}

HardCase case_of(const SceneParts& parts) {
  HardCases cases;
  cases.add("case", parts);
  return cases.take().front();
}

TEST(HardVerdict, EnergiesAndHeightsAreThoseOfAThrow) {
  const HardCase hard = case_of(thrown());
  const CaseResult result = run_on_cpu(hard);
  const double dt = 0.125;
  double v = 20, risen = 0, most_risen = 0, gain = -1;
  const double scale = 2 * 0.5 * v * v + 2 * g * 10 * h;  // per mass
  for (int step = 1; step <= 32; ++step) {
    v -= g * dt;
    risen += v * dt;
    most_risen = std::max(most_risen, risen);
    gain = std::max(gain, 2 * (0.5 * v * v - 0.5 * 400 + g * risen) / scale);
  }
  EXPECT_NEAR(result.energy_scale, h * h * scale, 1e-9 * h * h * scale);
  EXPECT_NEAR(result.energy_drift, 2 * (0.5 * v * v - 0.5 * 400 + g * risen) / scale, 1e-9);
  EXPECT_NEAR(result.energy_gain, gain, 1e-9);
  EXPECT_NEAR(result.kinetic_end, v * v / scale, 1e-9);
  EXPECT_NEAR(result.level_drift, 2 * risen / h, 1e-9);
  EXPECT_GT(result.rise, 0.9 * most_risen / h);  // seen twenty times on the way
  EXPECT_LE(result.rise, most_risen / h + 1e-9);
  EXPECT_EQ(result.statistics.steps(), 32u);
  EXPECT_EQ(result.outcome, Outcome::survived);
}

TEST(HardVerdict, EveryBoundCanBeMissed) {
  HardCase hard = case_of(thrown());
  hard.expected.closest = 1;
  CaseResult result = run_on_cpu(hard);
  EXPECT_TRUE(faults(hard, result).empty()) << faults(hard, result).front();
  const auto misses = [&](auto change) {
    HardCase strict = hard;
    change(strict.expected);
    return faults(strict, result).size() == 1;
  };
  EXPECT_TRUE(misses([](Expectation& e) { e.least_lost = 1; }));
  EXPECT_TRUE(misses([&](Expectation& e) { e.energy_gain = result.energy_gain - 1e-6; }));
  EXPECT_TRUE(misses([](Expectation& e) { e.mean_compression = -1e-6; }));
  EXPECT_TRUE(misses([&](Expectation& e) { e.rise = result.rise - 1e-6; }));
  EXPECT_TRUE(misses([&](Expectation& e) { e.level_drift = std::abs(result.level_drift) - 1e-6; }));
  EXPECT_TRUE(misses([&](Expectation& e) { e.kinetic_end = result.kinetic_end - 1e-6; }));
  EXPECT_TRUE(misses([](Expectation& e) { e.closest = 10.001; }));
  EXPECT_TRUE(misses([](Expectation& e) { e.warned = true; }));
  EXPECT_TRUE(misses([](Expectation& e) { e.outcome = Outcome::stopped; }));
  result.list_growths = 1;
  EXPECT_TRUE(misses([](Expectation& e) { e.list_growths = 0; }));
  EXPECT_FALSE(misses([](Expectation& e) { e.list_growths = 1; }));
  result.energy_gain = unknown;
  EXPECT_TRUE(misses([](Expectation& e) { e.energy_gain = 1; })) << "what is unknown is within no bound";
}

TEST(HardVerdict, ALossIsAFault) {
  SceneParts parts = thrown();
  parts.fluid += block({10 * h, h}, 1, 1, {0, -40});
  for (int i = 0; i < 10; ++i) parts.fluid += block({2 * h * (i + 1.0), 30 * h}, 1, 1, {0, 20});
  HardCase hard = case_of(parts);
  const CaseResult result = run_on_cpu(hard);
  EXPECT_EQ(result.statistics.lost(), 1u);
  EXPECT_EQ(faults(hard, result).size(), 1u);
  hard.expected.lost = 1;
  EXPECT_TRUE(faults(hard, result).empty());
}

TEST(HardVerdict, AValueThatIsNotFiniteIsAFault) {
  const HardCase hard = case_of(thrown());
  CaseResult result = run_on_cpu(hard);
  result.end.pressure[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faults(hard, result).size(), 1u);
}

/// A fluid that falls out of its domain.
HardCase lost_case() {
  SceneParts parts = thrown();
  parts.time = fixed(0.125, 40);
  HardCase hard = case_of(parts);
  expect_stop(hard.expected, blown_up);
  return hard;
}

TEST(HardVerdict, AStopHasToSayWhereAndWhyAndInTime) {
  HardCase hard = lost_case();
  const CaseResult result = run_on_cpu(hard);
  ASSERT_EQ(result.outcome, Outcome::stopped);
  EXPECT_TRUE(faults(hard, result).empty()) << faults(hard, result).front();

  CaseResult nowhere = result;
  nowhere.failure->x.y = unknown;
  EXPECT_EQ(faults(hard, nowhere).size(), 1u);
  CaseResult at_another_time = result;
  at_another_time.failure->step -= 1;
  EXPECT_EQ(faults(hard, at_another_time).size(), 1u);
  CaseResult nobody = result;
  nobody.failure->id = 2;
  EXPECT_EQ(faults(hard, nobody).size(), 1u);

  hard.expected.stopped_by = result.failure->step;
  EXPECT_TRUE(faults(hard, result).empty());
  hard.expected.stopped_by = result.failure->step - 1;
  EXPECT_EQ(faults(hard, result).size(), 1u);
  hard.expected = {};
  EXPECT_EQ(faults(hard, result).size(), 1u) << "it should have survived";
  allow_stop(hard.expected, blown_up);
  EXPECT_TRUE(faults(hard, result).empty()) << "or not";
  allow_stop(hard.expected, collapsed);
  EXPECT_EQ(faults(hard, result).size(), 1u) << "but not for this";
}

TEST(HardVerdict, ATwinHasToHaveTheSameBits) {
  HardCase hard = case_of(thrown());
  hard.same_as = hard.scene;
  EXPECT_TRUE(faults(hard, run_on_cpu(hard)).empty());
  SceneParts other = thrown();
  other.gravity = std::nextafter(other.gravity, 10);
  hard.same_as = scene_text(other);
  EXPECT_EQ(faults(hard, run_on_cpu(hard)).size(), 1u);
}

TEST(HardVerdict, TheClosestTwoAreFoundWhereverTheyAre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Vec2> points(300);
  for (Vec2& x : points) x = {place(random), 100 * place(random)};
  double closest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) closest = std::min(closest, glm::length(points[i] - points[j]));
  }
  EXPECT_EQ(closest_distance(points), closest);
  EXPECT_EQ(closest_distance({Vec2(1)}), std::numeric_limits<double>::infinity());
}

TEST(HardVerdict, ARowHasACellForEveryColumn) {
  const HardCase hard = lost_case();
  const std::vector<std::string> row = hard_row(hard, run_on_cpu(hard));
  const auto& columns = hard_columns();
  ASSERT_EQ(row.size(), columns.size());
  const auto cell = [&](const char* name) { return row.at(place_of(name, columns)); };
  EXPECT_EQ(cell("case"), "case_iisph");
  EXPECT_EQ(cell("backend"), "cpu");
  EXPECT_EQ(cell("dt"), "0.125");
  EXPECT_EQ(cell("failure_step"), cell("steps"));
  EXPECT_EQ(cell("lost"), "1");
  EXPECT_EQ(cell("verdict"), "as expected");
  EXPECT_TRUE(is_as_expected(row));
  const auto without = hard_row_without(hard, "gpu", "crashed");
  EXPECT_EQ(without.size(), columns.size());
  EXPECT_FALSE(is_as_expected(without));
  for (const std::string& column : hard_page_columns()) EXPECT_LT(place_of(column, columns), columns.size());
}

TEST(TextTable, KeepsCellsApart) {
  const TextTable table{{"a", "b"}, {{"1,5", "say \"no\""}, {"x|y", ""}}};
  EXPECT_EQ(table.csv(), "a,b\n\"1,5\",\"say \"\"no\"\"\"\nx|y,\n");
  EXPECT_EQ(table.markdown(), "| a | b |\n|---|---|\n| 1,5 | say \"no\" |\n| x\\|y |  |\n");
  EXPECT_EQ(table.only({"b"}).csv(), "b\n\"say \"\"no\"\"\"\n\n");
}

}  // namespace
}  // namespace sluice::test
