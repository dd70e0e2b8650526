// The backend in double equals a step written straight from the equations, for every scene and method.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

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

/// Fields without an equation of their own: states, which are compared as a snapshot, and parts of sums and
/// iterates of the solve, which show in what they add up to.
const std::set<Field> not_compared = {Field::x_in,
                                      Field::v_in,
                                      Field::p_in,
                                      Field::rho_in,
                                      Field::x,
                                      Field::v,
                                      Field::wall_density,
                                      Field::wall_gradient,
                                      Field::wall_gradient_squares,
                                      Field::q,
                                      Field::q_best,
                                      Field::q_before,
                                      Field::Ap,
                                      Field::Ap_before};

/// Expects a field to agree. Zeros equal zeros, except in fields that are never zero throughout: there
/// they would mean that nothing was compared.
template <class T>
void expect_field(const Simulation& simulation, Field which, const std::vector<T>& reference) {
  const std::set<Field> always = {Field::rho, Field::a_n, Field::p, Field::a_p};
  const std::vector<T> values = field<T>(simulation, which);
  if (!always.contains(which) && values == std::vector<T>(reference.size()) && values == reference) return;
  EXPECT_LT(relative_difference(values, reference), tolerance) << info(which).name;
}

void expect_agreement(const Simulation& simulation, const StepReport& report, const BruteForce& reference) {
  const FieldSet planned = make_plan(model_of(simulation.scene)).fields();
  for (uint32_t i = 0; i < field_count; ++i) {
    const auto which = static_cast<Field>(i);
    if (!planned.has(which) || info(which).length != Length::fluid || not_compared.contains(which)) continue;
    if (reference.reals.contains(which))
      expect_field(simulation, which, reference.reals.at(which));
    else if (reference.vectors.contains(which))
      expect_field(simulation, which, reference.vectors.at(which));
    else
      EXPECT_TRUE(is_integer(which) || info(which).type == Type::vec4)
          << "tests/support/brute_force.cpp does not compute " << info(which).name;
  }
  if (simulation.scene.method == PressureMethod::iisph) {
    EXPECT_EQ(report.iterations, reference.iterations);
    EXPECT_NEAR(report.residual, reference.residual, tolerance * reference.residual);
    EXPECT_EQ(report.converged, reference.converged);
  }
  const Snapshot snapshot = simulation.simulator->snapshot();
  EXPECT_LT(relative_difference(snapshot.x, reference.x), tolerance);
  EXPECT_LT(relative_difference(snapshot.v, reference.v), tolerance);
}

void expect_moving_start_equals_the_equations(Scene scene) {
  for (FluidShape& shape : scene.fluid) {
    shape.velocity = {3, -2};
    shape.velocity_gradient = {{0.02, -0.01}, {0.03, -0.02}};
  }
  Simulation simulation(scene);
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

class EveryScene : public testing::TestWithParam<ShippedRun> {};

TEST_P(EveryScene, FirstStepEqualsTheEquations) {
  Simulation simulation(GetParam().load());
  BruteForce reference(simulation.scene, simulation.samples);
  reference.step();
  expect_agreement(simulation, simulation.run(1).back(), reference);
}

// The lattice of the start hides errors that only show off it, and velocities are zero there.
TEST_P(EveryScene, StepOfAJitteredMovingStartEqualsTheEquations) {
  expect_moving_start_equals_the_equations(GetParam().load({"fluid.jitter=0.15", "fluid.seed=7"}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(shipped_runs()),
                         [](const auto& test) { return test.param.name(); });

// Boundary models, viscosities and methods go together in any way.
TEST(BruteForceTest, EveryCombinationOfModelsEqualsTheEquations) {
  for (const BoundaryModel boundary : values_of<BoundaryModel>()) {
    for (const ViscosityModel viscosity : values_of<ViscosityModel>()) {
      for (const PressureMethod method : values_of<PressureMethod>()) {
        SCOPED_TRACE(fmt::format("{}, {}, {}", name_of(boundary), name_of(viscosity), name_of(method)));
        const char* coefficient = viscosity == ViscosityModel::xsph ? "0.05" : "200";
        expect_moving_start_equals_the_equations(shipped(
            "inclined_plane",
            {fmt::format("boundary.model={}", name_of(boundary)),
             fmt::format("viscosity.model={}", name_of(viscosity)),
             fmt::format("viscosity.coefficient={}", coefficient),
             fmt::format("pressure.method={}", name_of(method)), "fluid.jitter=0.15", "fluid.seed=3"}));
      }
    }
  }
}

// Solvers, wall terms, stop tests and a solve that is cut short, over some steps: each starts from the last
// one's pressure. Rounding grows with the sweeps.
TEST(BruteForceTest, EveryWayToSolveThePressureSystemEqualsTheEquations) {
  int dropped = 0, gone_back = 0;
  for (const std::string boundary : {"thesis", "symmetric", "akinci"}) {
    for (const std::string solver : {"jacobi", "barzilai-borwein"}) {
      for (const std::string stop : {"stop=density", "stop=residual", "max_iterations=3", "max_iterations=9",
                                     "source_weight=0.2", "omega=0.3"}) {
        SCOPED_TRACE(fmt::format("{}, {}, {}", boundary, solver, stop));
        Scene scene = shipped("breaking_dam",
                              {"fluid.rect.0.max=[100,120]", "fluid.jitter=0.1", "time.dt=0.06",
                               "boundary.model=" + std::string(boundary == "akinci" ? "akinci" : "mirror"),
                               "pressure.iisph.wall=" + (boundary == "akinci" ? "thesis" : boundary),
                               "pressure.iisph.solver=" + solver, "pressure.iisph." + stop,
                               stop == "max_iterations=9" ? "pressure.iisph.omega=1.6" : "scene.title=dam"});
        scene.fluid[0].velocity_gradient = {{-0.3, 0.1}, {0.2, 0.1}};
        Simulation simulation(scene);
        BruteForce reference(simulation.scene, simulation.samples);
        int capped = 0;
        for (int step = 0; step < 4; ++step) {
          reference.step();
          const StepReport report = simulation.run(1).back();
          ASSERT_EQ(report.iterations, reference.iterations) << step;
          EXPECT_EQ(report.converged, reference.converged) << step;
          if (!report.converged) ++capped;
          EXPECT_NEAR(report.residual, reference.residual, 1e-9 * reference.residual) << step;
          EXPECT_LT(relative_difference(field<double>(simulation, Field::p), reference.p), 1e-9) << step;
        }
        EXPECT_TRUE(capped > 0 || stop != "max_iterations=3");
        dropped += reference.dropped;
        gone_back += reference.gone_back;
      }
    }
  }
  EXPECT_GT(dropped, 0);
  EXPECT_GT(gone_back, 0);
}

TEST(BruteForceTest, AnyExponentOfTaitsEquationEqualsTheEquations) {
  for (const char* gamma : {"1", "1.5", "2", "6.999", "7", "7.3", "12.25", "64", "100.7"}) {
    SCOPED_TRACE(gamma);
    expect_moving_start_equals_the_equations(
        shipped("inclined_plane", {"pressure.method=wcsph", std::string("pressure.wcsph.gamma=") + gamma,
                                   "fluid.jitter=0.15", "fluid.seed=3"}));
  }
}

// The trajectory is the page's own, in every detail.
TEST(BruteForceTest, TwoHundredStepsOfTheWcsphBoxEqualTheEquations) {
  Simulation simulation(shipped("wcsph_box"));
  BruteForce reference(simulation.scene, simulation.samples);
  const auto largest_distance = [&] {
    const Snapshot snapshot = simulation.simulator->snapshot();
    double largest = 0;
    for (size_t i = 0; i < snapshot.x.size(); ++i)
      largest = std::max(largest, glm::length(snapshot.x[i] - reference.x[i]));
    return largest;
  };
  const auto run = [&](int steps) {
    for (int step = 0; step < steps; ++step) {
      simulation.run(1);
      reference.step();
    }
    return largest_distance();
  };
  EXPECT_LT(run(100), 1e-10);
  EXPECT_LT(run(100), 1e-8);
  EXPECT_GT(simulation.simulator->snapshot().x[0].y, 0);
}

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
