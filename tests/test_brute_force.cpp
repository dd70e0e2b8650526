// The backend in double equals a step written straight from the equations, for every scene and method.
#include <gtest/gtest.h>

#include "tests/support/brute_force.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

constexpr double tolerance = 1e-12;

/// A field of the backend in id order.
template <class T>
std::vector<T> field(const Simulation& simulation, Field field) {
  const size_t n = simulation.samples.fluid.size();
  std::vector<uint32_t> id(n);
  simulation.backend->download(Field::id, id);
  std::vector<T> values(n), sorted(n);
  simulation.backend->download(
      field, std::span(reinterpret_cast<double*>(values.data()), n * sizeof(T) / sizeof(double)));
  for (size_t i = 0; i < n; ++i) sorted[id[i]] = values[i];
  return sorted;
}

void expect_agreement(const Simulation& simulation, const StepReport& report, const BruteForce& reference) {
  const bool iisph = simulation.scene.method == PressureMethod::iisph;
  EXPECT_LT(relative_difference(field<double>(simulation, Field::rho), reference.rho), tolerance);
  EXPECT_LT(relative_difference(field<Vec2>(simulation, Field::a_n), reference.a_n), tolerance);
  EXPECT_LT(relative_difference(field<double>(simulation, Field::p), reference.p), tolerance);
  EXPECT_LT(relative_difference(field<Vec2>(simulation, Field::a_p), reference.a_p), tolerance);
  if (iisph) {
    EXPECT_LT(relative_difference(field<double>(simulation, Field::A_ii), reference.A_ii), tolerance);
    EXPECT_LT(relative_difference(field<double>(simulation, Field::s), reference.s), tolerance);
    EXPECT_EQ(report.iterations, reference.iterations);
    EXPECT_NEAR(report.residual, reference.residual, tolerance * reference.residual);
  }
  const Snapshot snapshot = simulation.simulator->snapshot();
  EXPECT_LT(relative_difference(snapshot.x, reference.x), tolerance);
  EXPECT_LT(relative_difference(snapshot.v, reference.v), tolerance);
}

using SceneAndMethod = std::tuple<std::string, std::string>;
class EveryScene : public testing::TestWithParam<SceneAndMethod> {};

TEST_P(EveryScene, FirstStepEqualsTheEquations) {
  const auto& [name, method] = GetParam();
  Simulation simulation(shipped(name, {"pressure.method=" + method}));
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

// The lattice of the start hides errors that only show off it, and velocities are zero there.
TEST_P(EveryScene, StepOfAJitteredMovingStartEqualsTheEquations) {
  const auto& [name, method] = GetParam();
  Scene scene = shipped(name, {"pressure.method=" + method, "fluid.jitter=0.15", "fluid.seed=7"});
  for (FluidShape& shape : scene.fluid) {
    shape.velocity = {3, -2};
    shape.velocity_gradient = {{0.02, -0.01}, {0.03, -0.02}};
  }
  Simulation simulation(scene);
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         testing::Combine(testing::ValuesIn(all_scenes()), testing::Values("iisph", "ssph")),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" + std::get<1>(test.param);
                         });

// The warm start, and strays far from the lattice, need more than one step.
TEST(BruteForceTest, TenStepsOfTheBreakingDamEqualTheEquations) {
  Simulation simulation(shipped("breaking_dam"));
  BruteForce reference(simulation.scene, simulation.samples);
  StepReport report;
  for (int step = 0; step < 10; ++step) {
    reference.step();
    report = simulation.run(1).back();
  }
  EXPECT_EQ(report.iterations, reference.iterations);
  const Snapshot snapshot = simulation.simulator->snapshot();
  EXPECT_LT(relative_difference(snapshot.x, reference.x), 1e-11);
  EXPECT_LT(relative_difference(snapshot.v, reference.v), 1e-10);
}

TEST(BruteForceTest, WiderKernelEqualsTheEquations) {
  Simulation simulation(shipped("breaking_dam", {"particles.smoothing=1.37", "fluid.jitter=0.1"}));
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

TEST(BruteForceTest, CentralForceAndNoBoundaryEqualTheEquations) {
  Scene scene = parse_scene(R"(
    [scene]
    title = "drop"
    [particles]
    spacing = 0.1
    rest_density = 1000
    [domain]
    min = [-3, -3]
    max = [3, 3]
    [fluid]
    gravity = [0, 0]
    central_force = 1.0
    centre = [0.1, -0.2]
    jitter = 0.1
    [[fluid.disc]]
    centre = [0.1, -0.2]
    radius = 1
    velocity_gradient = [[0.5, 0], [0, -0.5]]
    [pressure]
    method = "iisph"
    [time]
    dt = 0.01
    duration = 1
  )",
                            "drop.toml");
  Simulation simulation(scene);
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

}  // namespace
}  // namespace sluice::test
