// The system of the WCSPH page: known values of its first step, its guard cases, and for which time steps the
// box runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

std::vector<double> reals(const Simulation& simulation, Field field, size_t size) {
  std::vector<double> values(size);
  simulation.backend->download(field, values);
  return values;
}

/// How often each value occurs, rounded to six digits.
std::map<std::string, int> counts(const std::vector<double>& values) {
  std::map<std::string, int> counted;
  for (const double value : values) ++counted[fmt::format("{:.6g}", value)];
  return counted;
}

TEST(PseudoMass, IsTheKnownOneOnASingleLayer) {
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    const Simulation simulation(shipped("wcsph_box"), precision);
    const auto psi = reals(simulation, Field::Psi, simulation.samples.boundary.size());
    // Samples on straight walls and in corners see two neighbours, those beside a corner a third one across
    // it.
    const auto close_to = [&](double value) {
      return std::ranges::count_if(psi, [&](double mass) { return std::abs(mass - value) < 2e-5; });
    };
    EXPECT_EQ(close_to(3.66519), 410);
    EXPECT_EQ(close_to(3.54638), 8);
  }
}

TEST(PseudoMass, OfSamplesAsDenseAsFluidIsTheMassOfTheFluid) {
  Scene scene = shipped("wcsph_box");
  std::get<Container>(scene.boundary[0].geometry).layers = 5;
  Simulation simulation(scene);
  const auto psi = reals(simulation, Field::Psi, simulation.samples.boundary.size());
  EXPECT_NEAR(*std::min_element(psi.begin(), psi.end()), scene.mass() / 1.000862, 1e-5);
  EXPECT_GT(*std::max_element(psi.begin(), psi.end()), 1.2 * scene.mass()) << "on the outermost layers";
}

TEST(WcsphBox, FirstStepHasTheKnownDensityAndPressure) {
  Simulation simulation(shipped("wcsph_box"));
  simulation.run(1);
  const Snapshot snapshot = simulation.simulator->snapshot();
  // Row 15, column 20: in the middle of the block.
  EXPECT_NEAR(snapshot.density[15 * 40 + 20], 1000.86183, 1e-5);
  EXPECT_NEAR(snapshot.pressure[15 * 40 + 20], 211.6957, 1e-4);
  EXPECT_GT(counts(snapshot.density)["1000.86"], 1000);
  // At the free surface particles are missing: clamped, and without pressure.
  EXPECT_EQ(snapshot.density.back(), 1000);
  EXPECT_EQ(snapshot.pressure.back(), 0);
  EXPECT_EQ(*std::min_element(snapshot.density.begin(), snapshot.density.end()), 1000);
}

TEST(ClampedDensity, IsThatOfTheStartToo) {
  const Snapshot start = Simulation(shipped("wcsph_box")).simulator->snapshot();
  EXPECT_EQ(*std::min_element(start.density.begin(), start.density.end()), 1000);
  const Snapshot iisph = Simulation(shipped("iisph_box")).simulator->snapshot();
  EXPECT_LT(*std::min_element(iisph.density.begin(), iisph.density.end()), 800) << "of WCSPH only";
}

// The relaxation solves for the true density.
TEST(ClampedDensity, HasNoPartInTheRelaxation) {
  const std::vector<std::string> relaxed = {"fluid.jitter=0.2", "fluid.relax=5"};
  const Snapshot wcsph = Simulation(shipped("wcsph_box", relaxed)).simulator->snapshot();
  const Snapshot iisph = Simulation(shipped("iisph_box", relaxed)).simulator->snapshot();
  EXPECT_EQ(relative_difference(wcsph.x, iisph.x), 0);
}

/// Where float pressures stand from those in double, relative to the largest.
double error_in_float(const std::string& gamma) {
  const auto pressure = [&](Precision precision) {
    Simulation simulation(shipped("wcsph_box", {"pressure.wcsph.gamma=" + gamma, "fluid.jitter=0.1"}),
                          precision);
    simulation.run(1);
    return simulation.simulator->snapshot().pressure;
  };
  return relative_difference(pressure(Precision::single_), pressure(Precision::double_));
}

// rho/rho0 to the seventh less 1, by pow, would lose three of seven digits more.
TEST(Tait, LosesNoDigitsToCancellation) {
  EXPECT_LT(error_in_float("7"), 2e-5);
  EXPECT_LT(error_in_float("6.3"), 2e-5);
  EXPECT_GT(error_in_float("7"), 1e-9) << "nothing is compared";
}

Snapshot after_steps(const Scene& scene, uint64_t steps = 50) {
  Simulation simulation(scene);
  simulation.run(steps);
  return simulation.simulator->snapshot();
}

TEST(WcsphNeeds, NoXsphEqualsCoefficientZero) {
  Scene none = shipped("wcsph_box"), zero = none;
  none.viscosity_model = ViscosityModel::none;
  zero.viscosity = 0;
  EXPECT_FALSE(needs_of(zero).xsph);
  EXPECT_TRUE(same_bits(after_steps(none), after_steps(zero)));
  EXPECT_FALSE(same_bits(after_steps(none), after_steps(shipped("wcsph_box"))));
}

TEST(WcsphNeeds, XsphStageWithCoefficientZeroAddsNothing) {
  const Scene scene = shipped("wcsph_box", {"fluid.jitter=0.1"});
  Simulation simulation(scene);
  simulation.run(20);
  const size_t n = simulation.samples.fluid.size();
  const auto before = reals(simulation, Field::a_n, 2 * n);
  Params params = make_params(scene, static_cast<uint32_t>(n));
  params.xsph = 0;
  simulation.backend->configure(params, needs_of(scene));
  simulation.backend->run(Stage::xsph);
  EXPECT_EQ(reals(simulation, Field::a_n, 2 * n), before);
}

TEST(WcsphNeeds, ClampAtZeroChangesNoDensity) {
  const Scene scene = shipped("wcsph_box", {"fluid.jitter=0.1"});
  Simulation simulation(scene);
  simulation.run(20);
  const size_t n = simulation.samples.fluid.size();
  simulation.backend->run(Stage::density);
  const auto sums = reals(simulation, Field::rho, n);
  EXPECT_LT(*std::min_element(sums.begin(), sums.end()), 0.9 * scene.rest_density) << "nothing to clamp";
  Params params = make_params(scene, static_cast<uint32_t>(n));
  params.rho0 = 0;
  simulation.backend->configure(params, needs_of(scene));
  simulation.backend->run(Stage::clamp_density);
  EXPECT_EQ(reals(simulation, Field::rho, n), sums);
}

TEST(WcsphNeeds, AkinciBoundaryOutOfReachEqualsNone) {
  Scene with = shipped("wcsph_box", {"fluid.jitter=0.1"}), without = with;
  Container& box = std::get<Container>(with.boundary[0].geometry);
  box.min = {-2.9, 4.4};
  box.max = {2.9, 4.5};
  without.boundary.clear();
  without.boundary_model = BoundaryModel::none;
  EXPECT_TRUE(needs_of(with).pseudo_mass);
  EXPECT_FALSE(needs_of(without).pseudo_mass);
  EXPECT_TRUE(same_bits(after_steps(with), after_steps(without)));
}

TEST(WcsphNeeds, BoundaryModelsDiffer) {
  Scene akinci = shipped("wcsph_box"), mirror = akinci;
  mirror.boundary_model = BoundaryModel::mirror;
  EXPECT_FALSE(same_bits(after_steps(akinci), after_steps(mirror)));
}

/// The box over its 4 seconds.
struct Box {
  Box(const std::string& scene, const std::string& dt, Precision precision)
      : simulation(shipped(scene, {"time.dt=" + dt}), precision) {
    const auto steps = static_cast<uint64_t>(std::round(simulation.scene.duration / simulation.scene.dt));
    reports = simulation.run(steps);
    complete = reports.size() == steps;
  }
  Simulation simulation;
  std::vector<StepReport> reports;
  bool complete = false;
};

class BoxOver4Seconds : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(BoxOver4Seconds, IsClean) {
  const auto& [scene, dt] = GetParam();
  const Box box(scene, dt, Precision::single_);
  ASSERT_TRUE(box.complete);
  EXPECT_FALSE(box.simulation.simulator->failure());
  for (const StepReport& report : box.reports) {
    ASSERT_EQ(report.diagnostics.lost, 0u) << "step " << report.step;
    ASSERT_TRUE(report.converged) << "step " << report.step;
  }
  EXPECT_LT(box.reports.back().diagnostics.mean_compression, 0.02);
}

INSTANTIATE_TEST_SUITE_P(TimeSteps, BoxOver4Seconds,
                         testing::Values(std::tuple("wcsph_box", "0.0005"), std::tuple("wcsph_box", "0.001"),
                                         std::tuple("wcsph_box", "0.002"), std::tuple("wcsph_box", "0.003"),
                                         std::tuple("iisph_box", "0.002"), std::tuple("iisph_box", "0.003"),
                                         std::tuple("iisph_box", "0.004"), std::tuple("iisph_box", "0.005")),
                         [](const auto& test) {
                           std::string name = std::get<0>(test.param) + "_dt_" + std::get<1>(test.param);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(WcsphBox, BlowsUpBeyondItsTimeStepAndSaysWhere) {
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const Box box("wcsph_box", "0.0045", precision);
    EXPECT_FALSE(box.complete);
    const auto failure = box.simulation.simulator->failure();
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->step, box.reports.size());
    EXPECT_LT(failure->step, 100u);
    EXPECT_LT(failure->id, 1200u);
    EXPECT_NE(failure->reason.find("spacings in one step"), std::string::npos) << failure->reason;
  }
}

}  // namespace
}  // namespace sluice::test
