// Forces on boundary shapes: their sum is the step's wall_force; each is that of its own samples.
#include <gtest/gtest.h>

#include "core/measure/wall_forces.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

using Overrides = std::vector<std::string>;

std::vector<WallForce> forces_in(const Simulation& run) {
  return WallForces(run.scene, run.samples).in(*run.backend, run.simulator->sizes());
}

class WallForcesOf : public testing::TestWithParam<Overrides> {};

TEST_P(WallForcesOf, AddUpToTheForceOnAllWalls) {
  Simulation run(shipped("template", GetParam()));
  const StepReport report = run.run(60).back();
  Vec2 sum{};
  double largest = 0;
  for (const WallForce& each : forces_in(run)) {
    sum += each.force;
    largest = std::max(largest, glm::length(each.force));
  }
  ASSERT_GT(largest, 0);
  EXPECT_NEAR(sum.x, report.diagnostics.wall_force.x, 1e-10 * largest);
  EXPECT_NEAR(sum.y, report.diagnostics.wall_force.y, 1e-10 * largest);
}

INSTANTIATE_TEST_SUITE_P(Walls, WallForcesOf,
                         testing::Values(Overrides{}, Overrides{"pressure.iisph.wall=thesis"},
                                         Overrides{"boundary.model=akinci"},
                                         Overrides{"pressure.method=ssph"}));

// The floor bears the water, left and right wall push against each other, and the torque is that of the
// floor's force in the middle of the tank.
TEST(WallForces, OfATankAtRestAreThoseOfItsWalls) {
  Simulation run(shipped(
      "resting_fluid", {"pressure.iisph.tolerance=1e-5", "boundary.container.0.sides=[\"bottom\"]",
                        "boundary.container.1={min=[0,30],max=[400,600],sides=[\"left\"]}",
                        "boundary.container.2={min=[0,30],max=[400,600],sides=[\"right\"],name=\"right\"}"}));
  run.run(300);
  const auto forces = forces_in(run);
  ASSERT_EQ(forces.size(), 3u);
  const double weight = run.scene.mass() * static_cast<double>(run.samples.fluid.size()) * 9.81;
  EXPECT_NEAR(forces[0].force.y, -weight, 0.05 * weight);
  EXPECT_NEAR(forces[0].torque, 200 * forces[0].force.y, 0.02 * 200 * weight);
  EXPECT_LT(forces[1].force.x, -0.2 * weight);
  EXPECT_NEAR(forces[2].force.x, -forces[1].force.x, 0.05 * weight);
  EXPECT_EQ(name_of(run.scene.boundary[1]), "container.1");
  EXPECT_EQ(name_of(run.scene.boundary[2]), "right");
}

}  // namespace
}  // namespace sluice::test
