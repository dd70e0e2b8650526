// The yardstick of the benchmarks computes what the CPU backend computes: speeds given as multiples of it
// compare the same work.
#include <gtest/gtest.h>

#include "bench/wcsph_yardstick.hpp"
#include "bench/yardstick.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

constexpr double tolerance = 1e-4;  // float, sums in another order

Simulation moving_dam() {
  Simulation simulation(shipped("breaking_dam", {"fluid.jitter=0.2"}), Precision::single_);
  simulation.run(20);
  return simulation;
}

bench::Yardstick yardstick_of(const Simulation& simulation) {
  const Params params = make_params(simulation.scene, static_cast<uint32_t>(simulation.samples.fluid.size()));
  return {*simulation.backend, params, simulation.samples};
}

void run_sweep(const Simulation& simulation) {
  for (const Stage stage : simulation.simulator->plan()[Phase::sweep]) simulation.backend->run(stage);
}

TEST(YardstickTest, StartsFromTheBackendsPressures) {
  const Simulation simulation = moving_dam();
  EXPECT_LT(yardstick_of(simulation).difference(*simulation.backend), 1e-7);
}

TEST(YardstickTest, SweepEqualsTheBackends) {
  const Simulation simulation = moving_dam();
  bench::Yardstick yardstick = yardstick_of(simulation);
  // The system is solved already, so that a sweep would change little: start from no pressure instead.
  std::vector<double> zero(simulation.samples.fluid.size());
  simulation.backend->upload(Field::q, zero);
  bench::Yardstick from_zero = yardstick_of(simulation);
  for (int sweep = 0; sweep < 5; ++sweep) {
    run_sweep(simulation);
    const float error = from_zero.sweep();
    EXPECT_LT(from_zero.difference(*simulation.backend), tolerance) << "sweep " << sweep;
    std::array<double, 4> solve{};
    simulation.backend->download(Field::solve, solve);
    EXPECT_NEAR(static_cast<double>(error), solve[0], tolerance * solve[0]);
  }
  EXPECT_GT(yardstick.difference(*simulation.backend), 100 * tolerance);
}

TEST(YardstickTest, WcsphStepsEqualTheBackends) {
  Simulation simulation(shipped("wcsph_box", {"fluid.jitter=0.2"}), Precision::single_);
  simulation.run(300);  // among the walls
  const Params params = make_params(simulation.scene, static_cast<uint32_t>(simulation.samples.fluid.size()));
  bench::WcsphYardstick yardstick(*simulation.backend, params, simulation.samples);
  EXPECT_EQ(yardstick.difference(*simulation.backend), 0);
  simulation.run(1);
  EXPECT_GT(yardstick.difference(*simulation.backend), 100 * tolerance) << "a step changes nothing";
  yardstick.step();
  EXPECT_LT(yardstick.difference(*simulation.backend), tolerance);
  for (int step = 0; step < 5; ++step) {
    simulation.run(1);
    yardstick.step();
  }
  EXPECT_LT(yardstick.difference(*simulation.backend), 10 * tolerance);
}

}  // namespace
}  // namespace sluice::test
