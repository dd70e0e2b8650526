// Who is cheapest at equal error, and how far runs are apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "media/recording.hpp"
#include "studies/pareto.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {

using namespace study;
namespace {

const std::vector<Trade> trades{{"s", "A", "x", "a1", 1.0, 0.1},         {"s", "A", "y", "a2", 4.0, 0.01},
                                {"s", "A", "y", "a3", 3.0, 0.01},        {"s", "B", "z", "b1", 0.5, 0.2},
                                {"s", "B", "z", "b2", 5.0, 0.009},       {"s", "C", "z", "c1", 0.1, 0.5},
                                {"s", "C", "z", "c2", 9.0, std::nan("")}};

TEST(Cheapest, OfEachFamilyAtMostAsFarOff) {
  const std::vector<Cheapest> found = cheapest_at(trades, {0.2, 0.01, 0.001});
  ASSERT_EQ(found.size(), 3u);
  ASSERT_EQ(found[0].by_family.size(), 2u);
  EXPECT_EQ(found[0].by_family[0].label, "b1");
  EXPECT_EQ(found[0].by_family[1].label, "a1");
  ASSERT_EQ(found[1].by_family.size(), 2u);
  EXPECT_EQ(found[1].by_family[0].label, "a3");
  EXPECT_EQ(found[1].by_family[1].label, "b2");
  EXPECT_TRUE(found[2].by_family.empty());
}

TEST(Cheapest, TargetsAreTheErrorsOfCurves) {
  const std::vector<double> errors = errors_of_curves(trades, "A");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_NEAR(errors[0], 0.105, 1e-12);
  EXPECT_NEAR(errors[1], 0.0105, 1e-12);
  EXPECT_TRUE(errors_of_curves(trades, "D").empty());
}

TEST(Cheapest, IsSaidInWords) {
  const std::vector<Cheapest> found = cheapest_at(trades, {0.2, 0.001});
  EXPECT_EQ(words_for(found[0]), "b1: 0.5 s; A 2.0 times as long; C not at all");
  EXPECT_EQ(words_for(found[1]), "nobody");
}

TEST(Cheapest, LeastErrorIsThatOfANumber) {
  EXPECT_EQ(least_error(trades), 0.009);
  EXPECT_TRUE(std::isnan(least_error({})));
}

/// Three particles that move by `shift` from their places and `off`, at t = 0, 0.5 and 1.
Result moving(const TemporaryFolder& folder, const std::string& name, Vec2 shift, Vec2 off = {}) {
  const Scene scene = shipped("breaking_dam", {"fluid.rect.0.max=[\"6h\",\"4h\"]"});
  const Point point{.name = name, .scene = "breaking_dam"};
  Result result{point, PointFiles(folder.path, point), {{"settings", {{"particles", {{"spacing", 8.0}}}}}}};
  std::filesystem::create_directories(folder.path / "runs");
  media::RecordingWriter writer(result.files.recording, scene, Precision::double_, "cpu");
  Snapshot state{{{24, 24}, {32, 24}, {40, 24}}, std::vector<Vec2>(3), {1, 1, 1}, {0, 0, 0}};
  for (Vec2& x : state.x) x += off;
  for (uint64_t step = 0; step < 3; ++step) {
    StepReport report;
    report.step = step;
    report.time = 0.5 * static_cast<double>(step);
    writer.add(report, 0, state);
    for (Vec2& x : state.x) x += shift;
  }
  writer.commit();
  return result;
}

TEST(Distance, IsThatOfDisplacementsInSpacings) {
  const TemporaryFolder folder;
  const Result still = moving(folder, "still", {0, 0}), other = moving(folder, "other", {2.4, 3.2}, {5, 7});
  EXPECT_EQ(distance_between(still, still, 0.5), 0);
  EXPECT_NEAR(distance_between(still, other, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(distance_between(other, still, 1), 1, 1e-12);
  EXPECT_TRUE(std::isnan(distance_between(still, other, 0.75)));
}

}  // namespace
}  // namespace sluice::test
