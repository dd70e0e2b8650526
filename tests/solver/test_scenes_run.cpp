// Every shipped scene runs 200 steps with every method it has, loses nothing and stays within reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

using Case = std::tuple<ShippedRun, Precision>;
class ShippedScene : public testing::TestWithParam<Case> {};

TEST_P(ShippedScene, Runs200Steps) {
  const auto& [run, precision] = GetParam();
  Simulation simulation(run.load(), precision);
  const auto reports = simulation.run(200);
  // A state equation gives way until its pressure carries the fluid above; it overshoots to about twice that.
  const Scene& scene = simulation.scene;
  const auto [low, high] =
      std::minmax_element(simulation.samples.fluid.begin(), simulation.samples.fluid.end(),
                          [](Vec2 a, Vec2 b) { return a.y < b.y; });
  const double hydrostatic = scene.rest_density * glm::length(scene.gravity) * (high->y - low->y) / 2;
  const double stiffness = scene.method == PressureMethod::ssph    ? scene.ssph->stiffness
                           : scene.method == PressureMethod::wcsph ? scene.wcsph->kappa * scene.rest_density
                                                                   : std::numeric_limits<double>::infinity();
  const double allowed = 0.01 + 2.4 * hydrostatic / stiffness;
  ASSERT_EQ(reports.size(), 200u);
  for (const StepReport& report : reports) {
    const Diagnostics& d = report.diagnostics;
    ASSERT_TRUE(d.finite());
    ASSERT_EQ(d.lost, 0u) << "step " << report.step;
    ASSERT_LT(d.cfl, 1) << "step " << report.step;
    ASSERT_LT(d.mean_compression, allowed) << "step " << report.step;
    ASSERT_TRUE(report.converged) << "step " << report.step;
  }
  // Something moved, and it did not gain energy: the fluid starts at rest.
  const auto energy = [](const StepReport& r) {
    return r.diagnostics.kinetic_energy + r.diagnostics.potential_energy;
  };
  EXPECT_GT(reports.back().diagnostics.kinetic_energy, 0);
  EXPECT_LT(energy(reports.back()), energy(reports.front()) + 0.01 * std::abs(energy(reports.front())));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene,
                         testing::Combine(testing::ValuesIn(shipped_runs()),
                                          testing::Values(Precision::single_, Precision::double_)),
                         [](const auto& test) {
                           return std::get<0>(test.param).name() +
                                  (std::get<1>(test.param) == Precision::double_ ? "_double" : "_float");
                         });

struct Counts {
  const char* scene;
  size_t fluid, boundary;
};

TEST(SceneCounts, AreTheRecordedOnes) {
  for (const auto& [scene, fluid, boundary] :
       {Counts{"breaking_dam", 660, 591}, Counts{"leaking_dam", 4400, 2799},
        Counts{"falling_from_platform", 420, 732}, Counts{"inclined_plane", 132, 655},
        Counts{"resting_fluid", 1050, 471}, Counts{"wcsph_box", 1200, 418}, Counts{"iisph_box", 1200, 418}}) {
    const Samples samples = sample(shipped(scene));
    EXPECT_EQ(samples.fluid.size(), fluid) << scene;
    EXPECT_EQ(samples.boundary.size(), boundary) << scene;
  }
}

}  // namespace
}  // namespace sluice::test
