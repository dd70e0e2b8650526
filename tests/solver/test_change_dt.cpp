// A time step that changes while a run goes on: as if the scene had had it, and time goes on from where it
// was.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/context.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

void expect_equal(const Snapshot& found, const Snapshot& expected) {
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.v, expected.v);
  EXPECT_EQ(found.density, expected.density);
  EXPECT_EQ(found.pressure, expected.pressure);
}

class ChangeDt : public testing::TestWithParam<const char*> {};

TEST_P(ChangeDt, BeforeTheFirstStepIsTheSceneWithThatStep) {
  const Scene scene = shipped(GetParam());
  Simulation changed(scene), set(shipped(GetParam(), {fmt::format("time.dt={:.17g}", 0.7 * scene.dt)}));
  changed.simulator->change_dt(0.7 * scene.dt);
  EXPECT_EQ(changed.simulator->dt(), set.scene.dt);
  const StepReport report = changed.run(30).back(), expected = set.run(30).back();
  EXPECT_EQ(report.dt, expected.dt);
  EXPECT_EQ(report.time, expected.time);
  EXPECT_EQ(report.iterations, expected.iterations);
  EXPECT_EQ(report.diagnostics.cfl, expected.diagnostics.cfl);
  expect_equal(changed.simulator->snapshot(), set.simulator->snapshot());
}

TEST_P(ChangeDt, OnTheGpuGivesTheSameBits) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  const Scene scene = shipped(GetParam());
  Simulation on_cpu(scene, Precision::single_);
  Gpu gpu;
  Simulator on_gpu(on_cpu.scene, on_cpu.samples, *gpu.backend);
  for (const double factor : {1.0, 0.5, 1.1}) {
    on_cpu.simulator->change_dt(factor * scene.dt);
    on_gpu.change_dt(factor * scene.dt);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(on_cpu.simulator->step().time, on_gpu.step().time);
    expect_equal(on_gpu.snapshot(), on_cpu.simulator->snapshot());
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ChangeDt, testing::Values("breaking_dam", "wcsph_box"));

TEST(ChangeDt, TimeGoesOnFromWhereItWas) {
  Simulation run(shipped("breaking_dam"));
  run.run(10);
  EXPECT_EQ(run.simulator->time(), 10 * 0.04);
  run.simulator->change_dt(0.02);
  EXPECT_EQ(run.simulator->time(), 10 * 0.04);
  EXPECT_EQ(run.run(3).back().time, 10 * 0.04 + 3 * 0.02);
  run.simulator->change_dt(0.01);
  EXPECT_EQ(run.run(1).back().time, 10 * 0.04 + 3 * 0.02 + 0.01);
  EXPECT_EQ(run.simulator->steps(), 14u);
}

}  // namespace
}  // namespace sluice::test
