// fluid.relax: the start loses its compression, moves stay bounded, velocities follow the relaxed positions.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

const std::vector<std::string> jittered = {"fluid.jitter=0.15", "fluid.seed=3"};

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

Snapshot start(const Scene& scene, Precision precision = Precision::double_) {
  return Simulation(scene, precision).simulator->snapshot();
}

TEST(Relax, TakesOutTheCompressionOfAJitteredStart) {
  auto overrides = jittered;
  const Snapshot before = start(shipped("breaking_dam", overrides));
  overrides.push_back("fluid.relax=20");
  const Scene scene = shipped("breaking_dam", overrides);
  const Snapshot after = start(scene);
  EXPECT_GT(largest(before.density), 1.05);
  EXPECT_LT(largest(after.density), 1.01);
  EXPECT_EQ(largest(after.pressure), 0) << "pressure starts at 0";
}

TEST(Relax, MovesAtMostATenthOfASpacingPerRound) {
  auto overrides = jittered;
  const Snapshot before = start(shipped("breaking_dam", overrides));
  overrides.push_back("fluid.relax=1");
  const Snapshot after = start(shipped("breaking_dam", overrides));
  double moved = 0;
  for (size_t i = 0; i < before.x.size(); ++i) moved = std::max(moved, glm::length(after.x[i] - before.x[i]));
  EXPECT_LE(moved, 0.1 * 8 * (1 + 1e-12));
  EXPECT_GT(moved, 0.05 * 8);
}

TEST(Relax, LeavesALatticeAtRestDensityAlmostWhereItIs) {
  const Snapshot before = start(shipped("resting_fluid"));
  const Snapshot after = start(shipped("resting_fluid", {"fluid.relax=5"}));
  double moved = 0;
  for (size_t i = 0; i < before.x.size(); ++i) moved = std::max(moved, glm::length(after.x[i] - before.x[i]));
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, 0.05 * 10);
}

TEST(Relax, VelocitiesAreSetFromTheRelaxedPositions) {
  Scene scene = shipped("breaking_dam", {"fluid.jitter=0.15", "fluid.relax=3"});
  scene.fluid[0].velocity = {1, 2};
  scene.fluid[0].velocity_gradient = {{0.1, 0.2}, {-0.3, 0.1}};
  const Snapshot snapshot = start(scene);
  for (size_t i = 0; i < snapshot.x.size(); ++i) {
    EXPECT_EQ(snapshot.v[i], start_velocity(scene.fluid[0], scene.spacing, snapshot.x[i]));
  }
}

TEST(Relax, WorksForSsphScenesAndInFloat) {
  const Scene scene =
      shipped("breaking_dam", {"fluid.jitter=0.15", "fluid.relax=20", "pressure.method=ssph"});
  EXPECT_LT(largest(start(scene).density), 1.01);
  EXPECT_LT(largest(start(scene, Precision::single_).density), 1.01);
}

// The wall is the scene's, whatever its method.
TEST(Relax, IsTheSameWithEveryMethod) {
  const auto relaxed = [](const std::string& method, const std::string& wall) {
    return start(shipped("breaking_dam",
                         {"fluid.jitter=0.15", "fluid.relax=5", "pressure.method=" + method,
                          "pressure.iisph.wall=" + wall, "pressure.iisph.solver=barzilai-borwein"}))
        .x;
  };
  EXPECT_EQ(relaxed("ssph", "symmetric"), relaxed("iisph", "symmetric"));
  EXPECT_EQ(relaxed("ssph", "thesis"), relaxed("iisph", "thesis"));
  EXPECT_NE(relaxed("ssph", "symmetric"), relaxed("ssph", "thesis"));
}

// The relaxed dam starts more quietly than the jittered one: jitter without relaxation releases energy.
TEST(Relax, RelaxedStartReleasesLessEnergyThanAJitteredOne) {
  auto overrides = jittered;
  const auto energy = [&] {
    Simulation simulation(shipped("breaking_dam", overrides));
    return simulation.run(3).back().diagnostics.kinetic_energy;
  };
  const double loose = energy();
  overrides.push_back("fluid.relax=20");
  EXPECT_LT(energy(), 0.5 * loose);
}

}  // namespace
}  // namespace sluice::test
