// The largest time step of a grid of runs.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "media/recording.hpp"
#include "studies/timestep.hpp"
#include "studies/timestep_verdicts.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {

using namespace study;
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Three starts; the middle one of each step's cfl decides, and a step may pass above one that does not.
TEST(StepLimit, IsTheLargestStepWhoseMedianPasses) {
  const StepLimit limit = step_limit({{0.1, 0, 0.5},
                                      {0.1, 1, 0.6},
                                      {0.1, 2, infinite},  //
                                      {0.2, 0, 1.1},
                                      {0.2, 1, 0.9},
                                      {0.2, 2, 1.2},  //
                                      {0.3, 0, 1.0, 2},
                                      {0.3, 1, 0.8, 0},
                                      {0.3, 2, 7.0, 5},  //
                                      {0.4, 0, 2.0},
                                      {0.4, 1, 0.9},
                                      {0.4, 2, infinite}});
  EXPECT_EQ(limit.dt, 0.3);
  EXPECT_EQ(limit.lost, 2);
  EXPECT_EQ(limit.steady, 0.1);
  EXPECT_EQ(limit.least, 0);  // the third start passes nowhere
  EXPECT_EQ(limit.most, 0.4);
  EXPECT_FALSE(limit.at_the_end);
}

TEST(StepLimit, SaysWhenTheGridEndsTooSoon) {
  EXPECT_TRUE(step_limit({{0.1, 0, 0.5}, {0.2, 0, 1.0}}).at_the_end);
  EXPECT_EQ(step_limit({{0.1, 0, 1.5}, {0.2, 0, 1.1}}).dt, 0);
}

// Of an even number of starts both in the middle have to pass.
TEST(StepLimit, TakesTheLargerMiddleOfAnEvenNumber) {
  EXPECT_EQ(step_limit({{0.1, 0, 0.5}, {0.1, 1, 1.5}}).dt, 0);
  EXPECT_EQ(step_limit({{0.1, 0, 0.5}, {0.1, 1, 1.0}}).dt, 0.1);
}

TEST(Exponent, IsThatOfAPowerLaw) {
  EXPECT_NEAR(exponent({1, 4, 9}, {2, 1, 2.0 / 3}), -0.5, 1e-12);
  EXPECT_NEAR(exponent({8, 10, 20}, {0.06, 0.075, 0.15}), 1, 1e-12);
}

/// Limits as laws of the configuration.
struct Law {
  double power_of_h = 1, power_of_k = -0.5, best_nu = 400, ssph_at_10 = 0.035;

  double hump(double nu) const { return 1 / (1 + std::pow(std::log((nu + 30) / (best_nu + 30)), 2) / 4); }
  double limit(const Point& point) const {
    const double h = std::stod(point.fact("h")), nu = std::stod(point.fact("nu"));
    const double shape = hump(nu) / hump(200);
    if (point.fact("method") == "IISPH")
      return 0.0751 * std::pow(h / 10, power_of_h) * shape * (nu > 1000 ? 0.55 : 1);
    return ssph_at_10 * h / 10 * std::pow(std::stod(point.fact("k")) / 1e5, power_of_k) * shape;
  }
};

/// What the study makes of runs whose cfl is their dt over the limit of the law.
Report report_of(const Law& law) {
  std::vector<Result> results;
  for (const Point& point : timestep_points()) {
    if (point.fact("start") == "-1") continue;
    const double cfl = std::stod(point.fact("dt")) / law.limit(point);
    results.push_back({point,
                       PointFiles("none", point),
                       {{"valid", cfl < 2},
                        {"cfl_max", cfl},
                        {"lost", 0},
                        {"compression_mean", 0.001},
                        {"seconds", {{"total", 1}}}}});
  }
  return timestep_report(results);
}

std::vector<std::string> refuted(const Report& report) {
  std::vector<std::string> claims;
  for (const auto& row : report.tables[2].second.rows) {
    if (row[3] != "holds") claims.push_back(row[0]);
  }
  return claims;
}

using Claims = std::vector<std::string>;

// The grids reach far enough, and limits are found to a step of the grid.
TEST(TimestepStudy, FindsTheLimitsThatThereAre) {
  const Law law;
  const Report report = report_of(law);
  EXPECT_EQ(report.faults, Claims());
  EXPECT_EQ(refuted(report), Claims());
  const TextTable& limits = report.tables[1].second;
  EXPECT_EQ(limits.rows.size(), 38u);
  for (const auto& row : limits.rows) {
    const Point point{
        .name = "", .scene = "", .facts = {{"method", row[1]}, {"h", row[2]}, {"k", row[3]}, {"nu", row[4]}}};
    const double ratio = std::stod(row[5]) / law.limit(point);
    EXPECT_LE(ratio, 1.001) << row[1] << ' ' << row[2] << ' ' << row[3] << ' ' << row[4];
    EXPECT_GT(ratio, 1 / 1.027) << row[1] << ' ' << row[2] << ' ' << row[3] << ' ' << row[4];
    EXPECT_EQ(row[6], row[5]);
  }
}

TEST(TimestepStudy, AGridThatEndsTooSoonIsAFault) {
  EXPECT_EQ(report_of({.ssph_at_10 = 1}).faults.size(), 22u);      // all of SSPH pass everywhere
  EXPECT_EQ(report_of({.ssph_at_10 = 0.001}).faults.size(), 22u);  // and nowhere
}

TEST(TimestepStudy, EveryVerdictCanFail) {
  EXPECT_EQ(refuted(report_of({.power_of_h = 0.6})),
            (Claims{"Fig. 6.6: IISPH's largest dt is about linear in h"}));
  EXPECT_EQ(refuted(report_of({.power_of_k = -0.3})), (Claims{"from k = 1e5 on about as k^-1/2"}));
  EXPECT_EQ(refuted(report_of({.best_nu = 20})).size(), 2u);
}

// Three particles in a frame each unit of time, of which one is below the domain and very fast.
TEST(KineticEnergyAtEnd, IsThatOfTheLastFramesInTheTank) {
  const TemporaryFolder folder;
  const Scene scene = shipped("breaking_dam", {"fluid.rect.0.max=[\"6h\",\"4h\"]"});
  {
    media::RecordingWriter writer(folder.path / "run.rec", scene, Precision::double_, "cpu");
    for (uint64_t step = 0; step < 13; ++step) {
      StepReport report;
      report.step = step;
      report.time = static_cast<double>(step);
      const double speed = step < 3 ? 100 : step == 12 ? 3 : 1;
      writer.add(report, 0,
                 {{{24, 24}, {32, 900}, {40, -1}},
                  {{speed, 0}, {0, -speed}, {0, -1e6}},
                  {1, 1, 1},
                  {0, 0, 0},
                  step});
    }
    writer.commit();
  }
  // Nine frames with |v|² = 1 of two particles of mass 64, and one with 9.
  EXPECT_NEAR(kinetic_energy_at_end(folder.path / "run.rec"), 64 * (9 * 1 + 9) / 10.0, 1e-9);
}

}  // namespace
}  // namespace sluice::test
