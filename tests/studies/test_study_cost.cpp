// What the study `cost` concludes from costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "studies/cost.hpp"

namespace sluice::test {

using namespace study;
namespace {

/// The thesis's own numbers, as if they were ours, with the solver that it has.
std::vector<Cost> theirs() {
  std::vector<Cost> costs;
  for (const Published& row : published_costs()) {
    Cost cost{row.scene, row.method, row.dt, row.iterations, row.pressure_seconds, row.step_seconds};
    if (cost.method == "IISPH") cost.method = "IISPH, Jacobi";
    cost.compression = 9e-4;
    cost.valid = cost.dt != "0.0045";
    if (std::isnan(cost.step_seconds)) cost.step_seconds = cost.pressure_seconds = 1;
    costs.push_back(cost);
  }
  return costs;
}

std::vector<Starts> strays() { return {{"0.011", 9, 5, 0.4}, {"0.019", 9, 9, 0.9}}; }

std::vector<std::string> refuted(const TextTable& verdicts) {
  std::vector<std::string> claims;
  for (const auto& row : verdicts.rows) {
    if (row[3] != "holds") claims.push_back(row[0]);
  }
  return claims;
}

TEST(CostVerdicts, TheThesissNumbersBearOutTheThesis) {
  const TextTable verdicts = cost_verdicts(theirs(), strays());
  EXPECT_EQ(verdicts.rows.size(), 20u);
  EXPECT_EQ(refuted(verdicts), std::vector<std::string>());
}

/// Changes the cost of a run and says which claims no longer hold.
std::vector<std::string> refuted_with(const std::string& scene, const std::string& method,
                                      const std::string& dt, const std::function<void(Cost&)>& change) {
  std::vector<Cost> costs = theirs();
  const auto found = std::ranges::find_if(
      costs, [&](const Cost& cost) { return cost.scene == scene && cost.method == method && cost.dt == dt; });
  change(*found);
  return refuted(cost_verdicts(costs, strays()));
}

using Claims = std::vector<std::string>;

TEST(CostVerdicts, EveryClaimCanFail) {
  const std::string jacobi = "IISPH, Jacobi";
  EXPECT_EQ(refuted_with("breaking_dam", jacobi, "0.08", [](Cost& cost) { cost.iterations = 3; }),
            (Claims{"dam: more sweeps per step with larger dt"}));
  EXPECT_EQ(refuted_with("breaking_dam", jacobi, "0.08", [](Cost& cost) { cost.pressure_seconds = 10; }),
            (Claims{"dam: and a larger share of the time for pressure"}));
  EXPECT_EQ(refuted_with("breaking_dam", jacobi, "0.05", [](Cost& cost) { cost.step_seconds = 62; }),
            (Claims{"dam: IISPH, Jacobi is fastest at dt = 0.04"}));
  EXPECT_EQ(refuted_with("breaking_dam", jacobi, "0.03", [](Cost& cost) { cost.step_seconds = 73; }),
            (Claims{"dam: IISPH, Jacobi takes about as long for dt = 0.03 to 0.06"}));
  EXPECT_EQ(refuted_with("breaking_dam", "SSPH", "0.01", [](Cost& cost) { cost.step_seconds = 60; }),
            (Claims{"dam: IISPH, Jacobi beats SSPH"}));
  EXPECT_EQ(refuted_with("breaking_dam", "SSPH", "0.01", [](Cost& cost) { cost.compression = 2e-3; }),
            (Claims{"dam: SSPH's stiffness keeps the mean compression under 0.1 %"}));
  EXPECT_EQ(refuted_with("breaking_dam", "SSPH", "0.01", [](Cost& cost) { cost.lost = 1; }),
            (Claims{"dam: SSPH is stable at dt = 0.01"}));
  EXPECT_EQ(refuted_with("leaking_dam", "SSPH", "0.004", [](Cost& cost) { cost.step_seconds = 800; }),
            (Claims{"leak: IISPH, Jacobi is beaten by SSPH"}));
  EXPECT_EQ(refuted_with("leaking_dam", "SSPH", "0.0045", [](Cost& cost) { cost.valid = true; }),
            (Claims{"leak: SSPH at dt = 0.0045"}));
  EXPECT_EQ(refuted_with("breaking_dam", jacobi, "0.03", [](Cost& cost) { cost.compression = 2e-3; }).size(),
            1u);
  EXPECT_EQ(refuted(cost_verdicts(theirs(), {{"0.011", 9, 4, 0.4}, {"0.019", 9, 9, 0.9}})),
            (Claims{"dam: SSPH at dt = 0.011"}));
}

TEST(CostVerdicts, NothingIsConcludedFromNothing) {
  EXPECT_TRUE(cost_verdicts({}, {}).rows.empty());
  EXPECT_TRUE(cost_verdicts({{"breaking_dam", "SSPH", "0.01", 0, 0.1, 1, 9e-4}}, {}).rows.empty());
}

/// A run of the point that took so long, a part of it in two stages.
Result run_of(const std::string& name, double total, double acceleration, double state_equation) {
  const std::vector<Point> points = cost_points();
  const Point& point = *std::ranges::find(points, name, &Point::name);
  return {
      point,
      PointFiles("none", point),
      {{"valid", true},
       {"iterations_mean", 3.0},
       {"compression_mean", 5e-4},
       {"cfl_max", 0.2},
       {"lost", 0},
       {"seconds",
        {{"total", total},
         {"stages",
          {{"pressure_acceleration", acceleration}, {"state_equation", state_equation}, {"density", 9}}}}}}};
}

// Of three repeats the fastest counts; what SSPH does with its pressure is not the making of it.
TEST(CostStudy, TakesTheFastestAndThePressuresOwnStages) {
  const Report report = cost_report(
      {run_of("breaking_dam_jacobi_dt0.04_0", 4, 1, 0), run_of("breaking_dam_jacobi_dt0.04_1", 2, 1, 0),
       run_of("breaking_dam_jacobi_dt0.04_2", 3, 1, 0), run_of("breaking_dam_ssph_dt0.01_0", 5, 2, 0.5)});
  EXPECT_NE(
      report.page.find("| IISPH, Jacobi | 0.04 | 8.45 | 3.00 | 38.55 / 62.38 | 61.8 % | 1 / 2 | 50.0 % |"),
      std::string::npos)
      << report.page;
  EXPECT_NE(report.page.find("| 0.5 / 5 | 10.0 % |"), std::string::npos) << report.page;
}

}  // namespace
}  // namespace sluice::test
