// Whole runs of the pressure solvers: how many sweeps they need, deep columns, and what pressure they find.
// scripts/pressure_tables writes the same runs down in docs/pressure_solvers.md.
#include <gtest/gtest.h>

#include <cmath>

#include "core/output/summary.hpp"
#include "tests/support/column.hpp"

namespace sluice::test {
namespace {

RunStatistics whole_run(const std::string& scene, std::vector<std::string> settings) {
  Simulation simulation(shipped(scene, settings));
  const auto steps = static_cast<uint64_t>(std::llround(simulation.scene.duration / simulation.scene.dt));
  RunStatistics statistics;
  for (const StepReport& report : simulation.run(steps)) statistics.add(report);
  EXPECT_EQ(statistics.steps(), steps);
  EXPECT_EQ(statistics.not_converged(), 0u);
  EXPECT_EQ(statistics.lost(), 0u);
  return statistics;
}

TEST(Sweeps, BarzilaiBorweinTakesAFractionOfJacobisAtNoMoreCompression) {
  struct Run {
    const char *scene, *dt;
    double most;
  };
  for (const auto& [scene, dt, most] : {Run{"breaking_dam", "0.04", 4.0}, Run{"breaking_dam", "0.08", 8.0},
                                        Run{"leaking_dam", "0.02", 8.2}}) {
    SCOPED_TRACE(scene + std::string(" dt ") + dt);
    const std::string step = std::string("time.dt=") + dt;
    const RunStatistics jacobi = whole_run(scene, {step});
    const RunStatistics ours = whole_run(scene, {step, "pressure.iisph.solver=barzilai-borwein"});
    EXPECT_LE(ours.iterations_mean(), most);
    EXPECT_GT(jacobi.iterations_mean(), 2 * ours.iterations_mean());
    EXPECT_LE(ours.compression_mean(), jacobi.compression_mean());
  }
}

TEST(DeepColumns, TheSymmetricWallHoldsThem) {
  for (const uint32_t depth : {30u, 100u, 200u}) {
    for (const double nu : {0.0, 200.0}) {
      for (const double lambda : {0.4, 0.8}) {
        expect_held({10, depth, nu, lambda}, sound, 20);
      }
    }
  }
}

// Some of these runs become invalid; none hangs, and none fails in silence.
TEST(DeepColumns, WithTheThesissWallEverySolveEnds) {
  size_t not_converged = 0;
  for (const uint32_t depth : {30u, 100u, 200u}) {
    for (const double nu : {0.0, 200.0}) {
      for (const double lambda : {0.4, 0.8}) {
        Simulation simulation(Column{10, depth, nu, lambda}.load({}));
        const auto steps = static_cast<uint64_t>(20 / simulation.scene.dt);
        const auto reports = simulation.run(steps);
        EXPECT_TRUE(reports.size() == steps || simulation.simulator->failure());
        for (const StepReport& report : reports) {
          ASSERT_TRUE(std::isfinite(report.residual));
          if (!report.converged) ++not_converged;
        }
      }
    }
  }
  EXPECT_GT(not_converged, 10u);
}

TEST(PressureAtRest, OfATankIsThatOfWater) {
  const Column tank{100, 100, 200, 0.4};
  Simulation simulation(tank.load(sound), Precision::single_);
  PressureProfile profile(simulation.scene);
  for (int step = 0; step < 1660; ++step) {  // 60 s; a single step's pressure scatters by 100 %
    simulation.run(1);
    if (step >= 830) profile.add(simulation.simulator->snapshot());
  }
  EXPECT_FALSE(simulation.simulator->failure());
  EXPECT_LT(profile.error(100), 0.015);
}

TEST(PressureAtRest, IsQuietInTheModeForPressure) {
  const auto scatter = [](std::vector<std::string> settings) {
    settings.insert(settings.end(), sound.begin(), sound.end());
    Simulation simulation(Column{10, 200, 200, 0.4}.load(settings));
    double count = 0, sum = 0, squares = 0;
    for (const StepReport& report : simulation.run(783)) {
      if (report.step <= 391) continue;
      const double force = -report.diagnostics.wall_force.y;
      count += 1;
      sum += force;
      squares += force * force;
    }
    const double mean = sum / count;
    const double weight =
        static_cast<double>(simulation.samples.fluid.size()) * simulation.scene.mass() * 9.81;
    // A mean of 391 steps of which each is off by as much again is right to a tenth.
    EXPECT_NEAR(mean, weight, (settings.size() > sound.size() ? 0.01 : 0.2) * weight);
    return std::sqrt(squares / count - mean * mean) / mean;
  };
  EXPECT_GT(scatter({}), 0.3);
  EXPECT_LT(scatter({"pressure.iisph.source_weight=0.2", "pressure.iisph.warm_start=1",
                     "pressure.iisph.stop=residual", "pressure.iisph.tolerance=1e-2"}),
            0.05);
}

}  // namespace
}  // namespace sluice::test
