// How a pressure solve ends, and what it leaves: the solution, the best it has found, or nothing of a guess
// that led astray.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/larger.hpp"
#include "sluice/error.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

using Settings = std::vector<std::string>;

std::string iisph(const std::string& setting) { return "pressure.iisph." + setting; }

/// The moving dam, ready to solve its pressure system, with other settings of the solve.
struct Solve {
  explicit Solve(Settings settings, const std::string& scene = "breaking_dam", int steps = 120)
      : simulation(shipped(scene, with_jitter(settings))) {
    simulation.run(static_cast<uint64_t>(steps));
  }

  static Settings with_jitter(Settings settings) {
    settings.insert(settings.end(), {"fluid.jitter=0.1", "viscosity.coefficient=50"});
    return settings;
  }

  Backend& backend() { return *simulation.backend; }
  size_t n() const { return simulation.samples.fluid.size(); }

  std::vector<double> values(Field field, size_t count) {
    std::vector<double> found(count);
    backend().download(field, found);
    return found;
  }
  std::vector<double> values(Field field) { return values(field, n()); }

  /// Sweeps from q on until the solve is over; returns their number and sets `outcome`.
  uint32_t solve_from(const std::vector<double>& q) {
    backend().upload(Field::q, q);
    std::array<uint32_t, 2> sweeps{};
    backend().upload(Field::sweeps, sweeps);
    backend().sweep(simulation.simulator->plan()[Phase::sweep], std::numeric_limits<uint32_t>::max());
    backend().download(Field::sweeps, sweeps);
    outcome = static_cast<sluice::Solve>(sweeps[1]);
    return sweeps[0];
  }

  /// r = s - Ap of the q that stands there.
  std::vector<double> residuals() {
    backend().run(Stage::pressure_acceleration);
    backend().run(Stage::pressure_operator);
    std::vector<double> r = values(Field::s);
    const std::vector<double> Ap = values(Field::Ap);
    for (size_t i = 0; i < n(); ++i) r[i] -= Ap[i];
    return r;
  }

  /// e of the q that stands there, as a first sweep would measure it.
  double error_of_first_sweep() {
    backend().upload(Field::sweeps, std::array<uint32_t, 2>{});
    for (const Stage stage :
         {Stage::pressure_acceleration, Stage::pressure_operator, Stage::residual, Stage::stop_test})
      backend().run(stage);
    return values(Field::solve, 4)[0];
  }

  Simulation simulation;
  sluice::Solve outcome = sluice::Solve::unfinished;
};

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = larger(found, std::abs(value));
  return found;
}

const Settings tight{iisph("wall=symmetric"), iisph("stop=residual"), iisph("tolerance=1e-9"),
                     iisph("max_iterations=100000")};

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

// The convex problem that a symmetric system is: q >= 0, and no pressure where none is wanted.
TEST(PressureSolve, BothSolversFindTheOneSolution) {
  for (const Settings& boundary : {Settings{}, Settings{iisph("wall=thesis"), "boundary.model=akinci"}}) {
    std::vector<std::vector<double>> found;
    std::vector<uint32_t> sweeps;
    for (const std::string solver : {"jacobi", "barzilai-borwein"}) {
      Solve solve(with(with(tight, boundary), {iisph("solver=" + solver), "time.dt=0.05"}), "breaking_dam",
                  0);
      solve.simulation.run(1);
      sweeps.push_back(solve.solve_from(std::vector<double>(solve.n(), 0.0)));
      EXPECT_EQ(solve.outcome, sluice::Solve::converged) << solver;
      found.push_back(solve.values(Field::q));
      const std::vector<double> r = solve.residuals();
      const double source = largest(solve.values(Field::s));
      size_t wet = 0;
      for (size_t i = 0; i < solve.n(); ++i) {
        EXPECT_GE(found.back()[i], 0);
        if (found.back()[i] > 0) {
          EXPECT_LT(std::abs(r[i]), 1e-7 * source) << solver << " " << i;
          ++wet;
        } else {
          EXPECT_GT(r[i], -1e-7 * source) << solver << " " << i;
        }
      }
      EXPECT_GT(wet, solve.n() / 2);
    }
    std::vector<double> difference = found[0];
    for (size_t i = 0; i < difference.size(); ++i) difference[i] -= found[1][i];
    // Free surfaces leave the system nearly singular, so the pressures differ by more than the residuals do.
    EXPECT_LT(largest(difference), 1e-4 * largest(found[0]));
    EXPECT_LT(3 * sweeps[1], sweeps[0]);
  }
}

// The thesis's wall at a tight tolerance does not converge; what is left is the best there was.
TEST(PressureSolve, AtTheCapTheBestIsKept) {
  for (const std::string solver : {"jacobi", "barzilai-borwein"}) {
    Solve solve(
        {iisph("solver=" + solver), iisph("tolerance=1e-300"), iisph("max_iterations=400"), "time.dt=0.08"});
    const StepReport report = solve.simulation.run(1).back();
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 400u);
    solve.solve_from(std::vector<double>(solve.n(), 10.0));
    EXPECT_EQ(solve.outcome, sluice::Solve::capped);
    const std::vector<double> measured = solve.values(Field::solve, 4);
    const double e = solve.error_of_first_sweep();
    if (solver == "barzilai-borwein") {
      EXPECT_EQ(measured[3], -1);
      EXPECT_EQ(e, measured[1]);
    } else {
      EXPECT_EQ(measured[3], 1) << "the last was the best, and has been updated once more";
      EXPECT_LE(e, measured[1]);
    }
  }
}

/// A solve that goes astray: far too long steps.
// Not even where one sweep is all there is.
TEST(PressureSolve, AFirstGuessFarOffIsNeverWhatIsLeft) {
  for (const std::string most : {"1", "2"}) {
    Solve solve({iisph("max_iterations=" + most), iisph("min_iterations=1"), iisph("tolerance=1e-300")});
    const double q = largest(solve.values(Field::q));
    solve.solve_from(std::vector<double>(solve.n(), 1e6 * q));
    EXPECT_LT(largest(solve.values(Field::q)), 100 * q) << most;
  }
}

TEST(PressureSolve, ADivergingSolveGoesBackAndIsReported) {
  Solve solve({iisph("omega=1.9"), iisph("tolerance=1e-6")}, "breaking_dam", 2);
  const uint32_t sweeps = solve.solve_from(std::vector<double>(solve.n(), 0.0));
  EXPECT_EQ(solve.outcome, sluice::Solve::capped);
  EXPECT_LE(sweeps, 1000u);
  const std::vector<double> measured = solve.values(Field::solve, 4);
  EXPECT_TRUE(measured[0] > 1e6 || std::isnan(measured[0])) << measured[0];
  EXPECT_LT(measured[1], 1);
  EXPECT_EQ(measured[3], -1);
  EXPECT_TRUE(std::ranges::all_of(solve.values(Field::q), [](double q) { return std::isfinite(q); }));
  EXPECT_EQ(solve.error_of_first_sweep(), measured[1]);

  const StepReport report = solve.simulation.run(1).back();
  EXPECT_FALSE(report.converged);
  EXPECT_LT(report.residual, 1) << "that of the pressure which is used";
  EXPECT_FALSE(solve.simulation.simulator->failure());
}

TEST(PressureSolve, AFirstGuessFarOffIsDropped) {
  Solve solve({iisph("solver=barzilai-borwein"), iisph("wall=symmetric"), iisph("stop=residual"),
               iisph("tolerance=1e-8")});
  const double q = largest(solve.values(Field::q));
  const uint32_t from_zero = solve.solve_from(std::vector<double>(solve.n(), 0.0));
  const std::vector<double> expected = solve.values(Field::q);
  ASSERT_GT(from_zero, 2u);
  // One sweep finds out; the next are those from zero, but for steps that know of the one before.
  const uint32_t sweeps = solve.solve_from(std::vector<double>(solve.n(), 1e4 * q));
  EXPECT_EQ(solve.outcome, sluice::Solve::converged);
  EXPECT_LT(sweeps, 2 * from_zero);
  EXPECT_LT(relative_difference(solve.values(Field::q), expected), 1e-4);
  Solve jacobi({});
  const uint32_t jacobi_from_zero = jacobi.solve_from(std::vector<double>(jacobi.n(), 0.0));
  const std::vector<double> jacobi_expected = jacobi.values(Field::q);
  EXPECT_EQ(jacobi.solve_from(std::vector<double>(jacobi.n(), 1e4 * q)), jacobi_from_zero + 1);
  EXPECT_EQ(jacobi.values(Field::q), jacobi_expected);
}

// In free fall nothing is compressed and nothing approaches: no pressure, whatever was there before.
TEST(PressureSolve, WithoutASourceThereIsNoPressure) {
  for (const std::string stop : {"density", "residual"}) {
    Solve solve({iisph("stop=" + stop), "boundary.container=[]", "fluid.rect.0.max=[\"4h\",\"243\"]"},
                "breaking_dam", 3);
    EXPECT_LE(largest(solve.values(Field::q)), 0);
    const uint32_t sweeps = solve.solve_from(std::vector<double>(solve.n(), 10.0));
    EXPECT_EQ(solve.outcome, sluice::Solve::converged) << stop;
    EXPECT_LE(sweeps, 3u) << stop;
    EXPECT_EQ(largest(solve.values(Field::q)), 0) << stop;
    const StepReport report = solve.simulation.run(1).back();
    EXPECT_EQ(report.iterations, 2u);
    EXPECT_EQ(report.residual, 0);
    EXPECT_TRUE(report.converged);
  }
}

// The update after the last measurement must not lead away, though a Barzilai-Borwein step may.
TEST(PressureSolve, WhatASolveLeavesIsWithinTheTolerance) {
  for (const Settings& stop : {Settings{iisph("stop=residual"), iisph("tolerance=1e-2")}, Settings{}}) {
    for (const std::string solver : {"jacobi", "barzilai-borwein"}) {
      for (const std::string dt : {"0.02", "0.08"}) {
        Solve solve(with(stop, {iisph("solver=" + solver), iisph("wall=symmetric"), "time.dt=" + dt}),
                    "breaking_dam", 0);
        const double tolerance = solve.simulation.scene.iisph.tolerance;
        for (int step = 0; step < 100; ++step) {
          EXPECT_TRUE(solve.simulation.run(1).back().converged);
          EXPECT_LT(solve.error_of_first_sweep(), 1.5 * tolerance) << solver << ", dt " << dt << ", " << step;
        }
      }
    }
  }
}

TEST(PressureSolve, ResidualStopBoundsTheRelativeResidual) {
  Solve solve({iisph("stop=residual"), iisph("tolerance=1e-2"), iisph("wall=symmetric"),
               iisph("solver=barzilai-borwein")});
  solve.solve_from(std::vector<double>(solve.n(), 0.0));
  EXPECT_EQ(solve.outcome, sluice::Solve::converged);
  const std::vector<double> q = solve.values(Field::q), r = solve.residuals(), s = solve.values(Field::s);
  double squares = 0, source = 0;
  for (size_t i = 0; i < q.size(); ++i) {
    if (q[i] > 0 || r[i] < 0) squares += r[i] * r[i];
    if (s[i] < 0) source += s[i] * s[i];
  }
  EXPECT_LT(std::sqrt(squares / source), 1e-2);
  EXPECT_GT(std::sqrt(squares / source), 1e-3);
}

// What it is all for; whole runs are in the long suite.
TEST(PressureSolve, BarzilaiBorweinNeedsAFractionOfTheSweepsAtNoMoreCompression) {
  const auto run = [](const std::string& solver, const std::string& dt) {
    Simulation simulation(shipped("breaking_dam", {iisph("solver=" + solver), "time.dt=" + dt}));
    double sweeps = 0, compression = 0;
    const auto reports = simulation.run(static_cast<uint64_t>(std::llround(20 / simulation.scene.dt)));
    for (const StepReport& report : reports) {
      sweeps += report.iterations;
      compression += report.diagnostics.mean_compression;
      EXPECT_TRUE(report.converged);
    }
    const auto steps = static_cast<double>(reports.size());
    return std::pair(sweeps / steps, compression / steps);
  };
  for (const auto& [dt, most] : {std::pair{"0.04", 4.2}, std::pair{"0.08", 9.0}}) {
    const auto [jacobi_sweeps, jacobi_compression] = run("jacobi", dt);
    const auto [sweeps, compression] = run("barzilai-borwein", dt);
    EXPECT_LT(sweeps, most) << dt;
    EXPECT_LT(2 * sweeps, jacobi_sweeps) << dt;
    EXPECT_LE(compression, jacobi_compression) << dt;
  }
}

/// A device that stopped to compute, as one whose driver was reset: it takes work and does none.
class DeadDevice final : public ForwardingBackend {
 public:
  using ForwardingBackend::ForwardingBackend;
  void sweep(const std::vector<Stage>&, uint32_t times) override { asked_for += times; }
  uint64_t asked_for = 0;
};

TEST(PressureSolve, ADeviceThatDoesNotComputeEndsTheRun) {
  const Scene scene = shipped("breaking_dam", {iisph("max_iterations=50")});
  const Samples samples = sample(scene);
  const auto cpu = cpu::make_backend(Precision::single_, 1);
  DeadDevice dead(*cpu);
  Simulator simulator(scene, samples, dead);
  try {
    simulator.step();
    FAIL() << "nothing was said";
  } catch (const EnvironmentError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(" does not compute any more: "), std::string::npos) << message;
    EXPECT_NE(message.find("use --backend cpu"), std::string::npos) << message;
  }
  EXPECT_GE(dead.asked_for, 50u) << "a slow solve may take as many";
  EXPECT_LE(dead.asked_for, 50u + 2 * 64u);
}

}  // namespace
}  // namespace sluice::test
