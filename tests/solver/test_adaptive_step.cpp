// Time steps that follow the fluid: no particle moves further in a step than the scene allows, or the run
// says why; a step that went too far leaves no trace; and both backends take the same steps to the last bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/solver/time_step.hpp"
#include "gpu/context.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

std::vector<std::string> adaptive(double cfl, double dt_min, double dt_max,
                                  std::vector<std::string> others = {}) {
  others.insert(others.end(), {fmt::format("time.cfl={}", cfl), fmt::format("time.dt_min={}", dt_min),
                               fmt::format("time.dt_max={}", dt_max)});
  return others;
}

/// A block that falls on the floor, fast.
const std::vector<std::string> falling{"fluid.rect=[{min=[\"3h\",\"20h\"],count=[22,12],velocity=[0,-150]}]",
                                       "pressure.iisph.solver=barzilai-borwein"};

Scene fall(double dt_min = 1e-4, const std::string& method = "iisph") {
  std::vector<std::string> overrides = falling;
  overrides.push_back("pressure.method=" + method);
  return shipped("breaking_dam", adaptive(0.8, dt_min, 0.1, overrides));
}

struct RunTo {
  std::vector<StepReport> reports;
  Snapshot state;
  std::optional<Failure> failure;
};

RunTo run_to(double end, const Scene& scene, Backend& backend) {
  const Samples samples = sample(scene);
  Simulator simulator(scene, samples, backend);
  RunTo run;
  while (simulator.time() < end && !simulator.failure()) run.reports.push_back(simulator.step(end));
  run.state = simulator.snapshot();
  run.failure = simulator.failure();
  return run;
}

RunTo run_on_cpu(double end, const Scene& scene, Precision precision = Precision::single_, int threads = 1) {
  return run_to(end, scene, *cpu::make_backend(precision, threads));
}

uint32_t repeats(const RunTo& run) {
  uint32_t sum = 0;
  for (const StepReport& report : run.reports) sum += report.repeats;
  return sum;
}

TEST(AdaptiveStep, NoParticleMovesFurtherThanAllowed) {
  const std::vector<std::pair<Scene, double>> runs = {{fall(), 2},
                                                      {fall(1e-4, "ssph"), 2},
                                                      {shipped("breaking_dam", adaptive(0.3, 1e-4, 0.1)), 6},
                                                      {shipped("wcsph_box", adaptive(0.2, 1e-5, 0.01)), 0.5},
                                                      {shipped("iisph_box", adaptive(0.5, 1e-5, 0.02)), 0.5}};
  for (const auto& [scene, end] : runs) {
    SCOPED_TRACE(fmt::format("{}, {}", scene.name, static_cast<int>(scene.method)));
    const RunTo run = run_on_cpu(end, scene);
    ASSERT_FALSE(run.failure) << run.failure->reason;
    double time = 0, dt_before = 1e9, dt_least = 1e9;
    for (const StepReport& report : run.reports) {
      ASSERT_LE(report.diagnostics.cfl, scene.adaptive->cfl) << "step " << report.step;
      ASSERT_LE(report.dt, scene.adaptive->dt_max);
      ASSERT_LE(report.dt, 1.1 * dt_before * (1 + 1e-12)) << "grows slowly";
      ASSERT_NEAR(report.time, time + report.dt, 1e-12 * end);
      time = report.time;
      dt_before = report.dt;
      dt_least = std::min(dt_least, report.dt);
    }
    EXPECT_EQ(time, end) << "to the last bit";
    EXPECT_LT(dt_least, 0.8 * run.reports.front().dt) << "it never adapted";
  }
}

// The steps that were taken, one after the other with a simulator that knows nothing of adapting, lead to the
// same bits: neither a repeated step nor the choice leaves a trace.
TEST(AdaptiveStep, ARepeatedStepLeavesNoTrace) {
  for (const std::string method : {"iisph", "ssph"}) {
    const Scene scene = fall(1e-4, method);
    for (const Precision precision : {Precision::single_, Precision::double_}) {
      const RunTo run = run_on_cpu(2, scene, precision);
      // Sound keeps the steps of SSPH too short for that.
      EXPECT_EQ(repeats(run) > 0, method == "iisph");
      std::vector<std::string> overrides = falling;
      overrides.push_back("pressure.method=" + method);
      Simulation replay(shipped("breaking_dam", overrides), precision);
      for (const StepReport& report : run.reports) {
        replay.simulator->change_dt(report.dt);
        const StepReport again = replay.simulator->step();
        ASSERT_EQ(again.iterations, report.iterations) << report.step;
        ASSERT_EQ(again.diagnostics.kinetic_energy, report.diagnostics.kinetic_energy) << report.step;
      }
      const Snapshot state = replay.simulator->snapshot();
      EXPECT_EQ(state.x, run.state.x);
      EXPECT_EQ(state.v, run.state.v);
      EXPECT_EQ(state.pressure, run.state.pressure);
    }
  }
}

TEST(AdaptiveStep, BothBackendsTakeTheSameSteps) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  for (const std::string method : {"iisph", "ssph"}) {
    const Scene scene = fall(1e-4, method);
    Gpu gpu;
    const RunTo on_gpu = run_to(1.5, scene, *gpu.backend);
    const RunTo on_cpu = run_on_cpu(1.5, scene), on_two = run_on_cpu(1.5, scene, Precision::single_, 2);
    EXPECT_EQ(repeats(on_gpu) > 0, method == "iisph");
    for (const RunTo& other : {on_cpu, on_two}) {
      ASSERT_EQ(on_gpu.reports.size(), other.reports.size());
      for (size_t k = 0; k < other.reports.size(); ++k) {
        ASSERT_EQ(on_gpu.reports[k].dt, other.reports[k].dt) << k;
        ASSERT_EQ(on_gpu.reports[k].repeats, other.reports[k].repeats) << k;
      }
      EXPECT_EQ(on_gpu.state.x, other.state.x);
      EXPECT_EQ(on_gpu.state.v, other.state.v);
      EXPECT_EQ(on_gpu.state.pressure, other.state.pressure);
    }
  }
}

TEST(AdaptiveStep, TheLastTwoShareWhatIsLeft) {
  const Scene scene = shipped("breaking_dam", adaptive(0.5, 1e-4, 0.01));
  const RunTo run = run_on_cpu(0.0351, scene);
  ASSERT_EQ(run.reports.size(), 4u);
  EXPECT_EQ(run.reports[0].dt, 0.01);
  EXPECT_EQ(run.reports[1].dt, 0.01);
  EXPECT_NEAR(run.reports[2].dt, 0.00755, 1e-12);
  EXPECT_NEAR(run.reports[3].dt, 0.00755, 1e-12);
  EXPECT_EQ(run.reports[3].time, 0.0351);
  EXPECT_EQ(run_on_cpu(0.004, scene).reports.size(), 1u);
  EXPECT_EQ(run_on_cpu(0.03, scene).reports.size(), 3u) << "a rounding error is no step";
  Simulation past(scene);
  past.simulator->step(0.001);
  EXPECT_THROW(past.simulator->step(0.001), std::logic_error);
}

// Whatever rounding makes of a sum of steps.
TEST(AdaptiveStep, EndsAreMetToTheLastBit) {
  const Scene scene = shipped("breaking_dam", adaptive(0.5, 1e-4, 0.0137));
  for (int k = 1; k <= 30; ++k) {
    const double end = 0.0291 + 0.00317 * k;
    ASSERT_EQ(run_on_cpu(end, scene).reports.back().time, end);
  }
}

TEST(AdaptiveStep, TheCutIsKnownBeforeIt) {
  Simulation simulation(shipped("breaking_dam", adaptive(0.5, 1e-4, 0.01)));
  Simulator& simulator = *simulation.simulator;
  EXPECT_FALSE(simulator.is_cut_short(0.0351));
  simulator.step(0.0351);
  EXPECT_FALSE(simulator.is_cut_short(0.0351));
  simulator.step(0.0351);
  EXPECT_TRUE(simulator.is_cut_short(0.0351));
  Simulation fixed(shipped("breaking_dam"));
  EXPECT_FALSE(fixed.simulator->is_cut_short(1e-9));
}

TEST(AdaptiveStep, ACollapseEndsTheRunAndNamesTheParticle) {
  const Scene scene = fall(0.08);
  const RunTo run = run_on_cpu(2, scene);
  ASSERT_TRUE(run.failure);
  EXPECT_EQ(run.failure->step, run.reports.size());
  EXPECT_EQ(run.failure->time, run.reports.back().time);
  EXPECT_NE(run.failure->reason.find("the time step collapsed: even with dt 0.08 a particle moved by"),
            std::string::npos)
      << run.failure->reason;
  const Vec2 v = run.state.v[run.failure->id];
  for (const Vec2 other : run.state.v) EXPECT_LE(glm::length(other), glm::length(v));
  EXPECT_EQ(run.failure->x, run.state.x[run.failure->id]);
}

// What is not finite is tried with smaller steps too, before the run ends.
TEST(AdaptiveStep, AStepThatIsNotFiniteIsRepeatedWithASmallerOne) {
  const RunTo run = run_on_cpu(1, fall(1e-6, "ssph"));
  EXPECT_FALSE(run.failure);
  const AdaptiveStep limits{0.5, 0.001, 1};
  const StepControl control(limits, 8, 10);
  Diagnostics d;
  d.kinetic_energy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(control.holds(d));
  EXPECT_EQ(control.shorter(0.1, d), 0.025);
  EXPECT_EQ(control.shorter(0.0015, d), 0.001);
  EXPECT_EQ(control.shorter(0.001, d), std::nullopt);
}

TEST(StepControlTest, TheLongestStepMovesAParticleByCflSpacings) {
  const StepControl control({0.5, 1e-9, 1e9}, 8, 1e9);
  for (const auto& [speed, acceleration] :
       {std::pair{3.0, 2.0}, {0.0, 2.0}, {3.0, 0.0}, {1e-3, 1e5}, {1e6, 1e-6}}) {
    const double dt = control.longest(speed, acceleration);
    EXPECT_NEAR(speed * dt + acceleration * dt * dt, 0.5 * 8, 1e-12);
  }
  EXPECT_EQ(control.longest(0, 0), 1e9) << "at rest only dt_max bounds it";
  EXPECT_EQ(StepControl({0.5, 0.1, 1}, 8, 1e9).longest(1e6, 0), 0.1);
  EXPECT_EQ(StepControl({0.5, 0.1, 1}, 8, 0.25).longest(0, 0), 0.25) << "the scene's own bound";
}

TEST(StepControlTest, ShrinksAtOnceAndGrowsSlowly) {
  const StepControl control({0.5, 1e-6, 1}, 8, 1e9);
  Diagnostics d;
  d.max_speed = 400;  // 0.01 without acceleration
  EXPECT_NEAR(control.next(0.5, d), 0.01, 1e-12);
  EXPECT_NEAR(control.next(0.001, d), 0.0011, 1e-12);
  d.max_speed_change = 400;  // an acceleration of 400/dt
  EXPECT_LT(control.next(0.01, d), 0.0065);
  d.cfl = 1;
  EXPECT_FALSE(control.holds(d));
  EXPECT_NEAR(*control.shorter(0.1, d), 0.1 * 0.9 * 0.5, 1e-12);
  d.cfl = 0.5;
  EXPECT_TRUE(control.holds(d));
}

// Numbers by hand for the dam: h = 8, nu = 200, g = 9.81, 30 rows, k = 7e5.
TEST(StepBoundsTest, OfViscositySoundAndDepth) {
  const auto bounds = [](std::vector<std::string> overrides) {
    const Scene scene = shipped("breaking_dam", overrides);
    return step_bounds(scene, sample(scene));
  };
  const StepBounds iisph = bounds({});
  EXPECT_NEAR(iisph.viscous.duration, 64.0 / 200, 1e-12);
  EXPECT_TRUE(std::isinf(iisph.sound.duration));
  EXPECT_NEAR(iisph.depth.duration, 8 / std::sqrt(9.81 * 29 * 8), 1e-12);
  EXPECT_NEAR(bounds({"viscosity.coefficient=0"}).safe(), 0.8 * iisph.depth.duration, 1e-12);
  const StepBounds ssph = bounds({"pressure.method=ssph", "viscosity.coefficient=0"});
  EXPECT_TRUE(std::isinf(ssph.viscous.duration));
  EXPECT_TRUE(std::isinf(ssph.depth.duration));
  EXPECT_NEAR(ssph.sound.duration, 8 / std::sqrt(7e5), 1e-12);
  EXPECT_NEAR(ssph.safe(), ssph.sound.duration, 1e-12);
  EXPECT_NEAR(bounds({"viscosity.coefficient=20000"}).safe(), 0.4 * 64 / 20000, 1e-12);
  const StepBounds central = bounds({"fluid.gravity=[0,0]", "fluid.central_force=4", "fluid.centre=[24,24]",
                                     "fluid.rect=[{min=[24,24],count=[1,11]}]"});
  EXPECT_NEAR(central.depth.duration, 8 / std::sqrt(0.5 * 4 * 80 * 80), 1e-12);
}

TEST(StepBoundsTest, ADropThatIsYetToFallAddsItsOwnDepthOnly) {
  const Scene scene = shipped(
      "breaking_dam",
      {"viscosity.coefficient=0", "fluid.rect=[{min=[24,24],count=[22,30]},{min=[24,5000],count=[3,3]}]"});
  const double depth = 29 * 8 + 16 + 2 * 8;  // of the dam, the gap as far as it is in reach, and the drop
  EXPECT_NEAR(step_bounds(scene, sample(scene)).depth.duration, 8 / std::sqrt(9.81 * depth), 1e-12);
}

TEST(StepBoundsTest, ImpactSpeedIsThatOfTheLongestFall) {
  const Scene scene = shipped("breaking_dam", {"fluid.rect.0.velocity=[30,-40]"});
  const Samples samples = sample(scene);
  double highest = 0;
  for (const Vec2 x : samples.fluid) highest = std::max(highest, x.y);
  EXPECT_NEAR(largest_impact_speed(scene, samples), std::sqrt(2500 + 2 * 9.81 * highest), 1e-9);
}

TEST(AdaptiveStep, XsphFollowsTheStep) {
  const Scene scene = shipped("wcsph_box", adaptive(0.2, 1e-5, 0.0017));
  Simulation adapting(scene), fixed(shipped("wcsph_box", {"time.dt=0.0017"}));
  EXPECT_EQ(adapting.simulator->step().dt, 0.0017);
  fixed.run(1);
  EXPECT_EQ(adapting.simulator->snapshot().v, fixed.simulator->snapshot().v);
}

}  // namespace
}  // namespace sluice::test
