// Particles that leave the domain do no harm and are named: which, in which step, where. On both backends
// alike.
#include <gtest/gtest.h>

#include <vector>

#include "gpu/context.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// Four particles in free flight without gravity, 10 spacings apart: one leaves to the left, one to the
/// right, one through the floor, and the last over the top, which is no loss. The first one comes back.
Scene leaving() {
  return shipped("breaking_dam",
                 {"boundary.container=[]", "viscosity.coefficient=0", "fluid.gravity=[0,0]", "time.dt=0.1",
                  "fluid.rect=[{min=[10,300],count=[1,1],velocity=[-40,0]},"
                  "{min=[390,300],count=[1,1],velocity=[24,0]},{min=[200,10],count=[1,1],velocity=[0,-30]},"
                  "{min=[200,590],count=[1,1],velocity=[0,40]}"
                  ",{min=[200,300],count=[8,8]}]"});
}

std::vector<Loss> losses_on(Backend& backend) {
  const Scene scene = leaving();
  const Samples samples = sample(scene);
  Simulator simulator(scene, samples, backend);
  for (int step = 0; step < 10; ++step) simulator.step();
  EXPECT_FALSE(simulator.failure());
  return simulator.losses();
}

void expect_losses(const std::vector<Loss>& losses) {
  ASSERT_EQ(losses.size(), 3u);
  EXPECT_EQ(losses[0].id, 0u);
  EXPECT_EQ(losses[0].step, 3u);
  EXPECT_NEAR(losses[0].time, 0.3, 1e-12);
  EXPECT_NEAR(losses[0].x.x, -2, 1e-4);
  EXPECT_NEAR(losses[0].x.y, 300, 1e-4);
  EXPECT_EQ(losses[1].id, 2u);
  EXPECT_EQ(losses[1].step, 4u);
  EXPECT_NEAR(losses[1].x.y, -2, 1e-4);
  EXPECT_EQ(losses[2].id, 1u);
  EXPECT_EQ(losses[2].step, 5u);
  EXPECT_NEAR(losses[2].x.x, 402, 1e-4);
}

TEST(Losses, AreNamedWithStepAndPlace) {
  expect_losses(losses_on(*cpu::make_backend(Precision::double_, 1)));
  expect_losses(losses_on(*cpu::make_backend(Precision::single_, 1)));
  Gpu gpu;
  expect_losses(losses_on(*gpu.backend));
}

StepReport report_of(uint64_t step) {
  StepReport report;
  report.step = step;
  return report;
}

TEST(Losses, OneThatComesBackAndLeavesAgainCountsOnce) {
  Params params;
  params.extent = {10, 10};
  params.origin = {100, 200};
  const std::vector<uint32_t> id{2, 0, 1};
  Losses losses;
  losses.note(report_of(7), params, id, std::vector<Vec2>{{-1, 5}, {5, -1}, {5, 5}});
  losses.note(report_of(8), params, id, std::vector<Vec2>{{1, 5}, {5, -1}, {5, 50}});
  losses.note(report_of(9), params, id, std::vector<Vec2>{{-1, 5}, {5, -1}, {11, 5}});
  ASSERT_EQ(losses.all().size(), 3u);
  EXPECT_EQ(losses.all()[0].id, 0u) << "those of a step by their ids";
  EXPECT_EQ(losses.all()[1].id, 2u);
  EXPECT_EQ(losses.all()[1].step, 7u);
  EXPECT_EQ(losses.all()[1].x, Vec2(99, 205));
  EXPECT_EQ(losses.all()[2].id, 1u);
  EXPECT_EQ(losses.all()[2].step, 9u);
}

// What left before a checkpoint did not leave after it.
TEST(Losses, OfTheTimeBeforeACheckpointAreNotNamedAgain) {
  const Scene scene = leaving();
  const Samples samples = sample(scene);
  const auto backend = cpu::make_backend(Precision::double_, 1);
  Simulator first(scene, samples, *backend);
  for (int step = 0; step < 4; ++step) first.step();
  Simulator resumed(scene, samples, *backend, first.state());
  for (int step = 0; step < 6; ++step) resumed.step();
  ASSERT_EQ(resumed.losses().size(), 1u);
  EXPECT_EQ(resumed.losses()[0].id, 1u);
  EXPECT_EQ(resumed.losses()[0].step, 5u);
}

TEST(Losses, ARunEndsWithThem) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(
      {"run", "breaking_dam", "--backend", "cpu", "--steps", "10", "--set", "boundary.container=[]", "--set",
       "viscosity.coefficient=0", "--set", "fluid.gravity=[0,0]", "--set", "time.dt=0.1", "--set",
       "fluid.rect=[{min=[10,300],count=[1,7],velocity=[-40,0]},{min=[200,100],count=[10,20]}]"},
      folder.path);
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find(
                "7 particles left the domain: particle 0 at step 3, time 0.3, near (-2, 300); particle "),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("; and 2 more\n"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sluice::test
