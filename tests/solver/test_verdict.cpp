// An invalid run is recognised, and blamed on the right particle for the right reason.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/solver/verdict.hpp"
#include "sluice/error.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Params params_of(uint32_t n) {
  Scene scene;
  scene.spacing = 1;
  scene.rest_density = 1;
  scene.dt = 0.5;
  scene.domain_max = {10, 10};
  return make_params(scene, n);
}

Snapshot at_rest(size_t n) {
  return {std::vector<Vec2>(n, {5, 5}), std::vector<Vec2>(n), std::vector<double>(n, 1),
          std::vector<double>(n), 7};
}

StepReport report_with(double cfl, uint32_t lost) {
  StepReport report;
  report.step = 8;
  report.time = 0.8;
  report.diagnostics.cfl = cfl;
  report.diagnostics.lost = lost;
  return report;
}

TEST(Verdict, LimitsAreWhereTheyAreSaidToBe) {
  const Params params = params_of(100);
  EXPECT_FALSE(is_suspect(report_with(100, 10), params));
  EXPECT_TRUE(is_suspect(report_with(100.1, 0), params));
  EXPECT_TRUE(is_suspect(report_with(0, 11), params));
  StepReport broken = report_with(0, 0);
  broken.diagnostics.kinetic_energy = std::nan("");
  EXPECT_TRUE(is_suspect(broken, params));
}

TEST(Verdict, NotFiniteNamesTheFirstSuchParticleAndItsLastFinitePlace) {
  for (const int what : {0, 1, 2, 3}) {
    Snapshot before = at_rest(100), after = at_rest(100);
    before.x[42] = {3, 4};
    after.x[42] = {3.5, 4};
    if (what == 0) after.x[42].y = std::nan("");
    if (what == 1) after.v[42].x = infinity;
    if (what == 2) after.density[42] = std::nan("");
    if (what == 3) after.pressure[42] = -infinity;
    EXPECT_FALSE(is_finite(after));
    const Failure failure = find_failure(report_with(infinity, 50), params_of(100), before, after);
    EXPECT_EQ(failure.id, 42u);
    EXPECT_EQ(failure.step, 8u);
    EXPECT_EQ(failure.x, what == 0 ? Vec2(3, 4) : Vec2(3.5, 4));
    EXPECT_EQ(failure.reason, "a value is not finite");
  }
}

// The square of a speed overflows long before the speed does.
TEST(Verdict, TooFastNamesTheFastestEvenWhereSquaresOverflow) {
  Snapshot after = at_rest(100);
  after.v[7] = {1e200, 0};
  after.v[9] = {0, -1e201};
  const Failure failure = find_failure(report_with(infinity, 0), params_of(100), at_rest(100), after);
  EXPECT_EQ(failure.id, 9u);
  EXPECT_EQ(failure.reason, "a particle moved by 5e+200 spacings in one step, more than 100");
}

TEST(Verdict, LostNamesTheFirstLostParticle) {
  Snapshot after = at_rest(100);
  for (const size_t i : {30u, 31u}) after.x[i] = {5, -0.1};
  after.x[20] = {5, 11};  // above the domain is not lost
  const Failure failure = find_failure(report_with(1, 11), params_of(100), at_rest(100), after);
  EXPECT_EQ(failure.id, 30u);
  EXPECT_EQ(failure.reason, "11 of 100 particles are lost, more than 10 %");
}

TEST(Verdict, StateOfAFailedRunIsTheLastFiniteOne) {
  // So stiff that pressure is infinite in float, and in double only throws a particle too far.
  for (const bool finite : {false, true}) {
    Simulation simulation(
        shipped("breaking_dam", {"pressure.method=ssph", "pressure.ssph.stiffness=1e40", "fluid.jitter=0.2"}),
        finite ? Precision::double_ : Precision::single_);
    const Snapshot start = simulation.simulator->snapshot();
    simulation.run(1);
    ASSERT_TRUE(simulation.simulator->failure());
    const Snapshot last = simulation.simulator->snapshot();
    EXPECT_TRUE(is_finite(last));
    EXPECT_EQ(last.step, finite ? 1u : 0u);
    EXPECT_EQ(last.x == start.x, !finite);
  }
}

TEST(Verdict, AStartBeyondFloatIsRefused) {
  Scene scene = shipped("breaking_dam");
  scene.fluid[0].velocity = {1e300, 0};
  EXPECT_NO_THROW(Simulation(scene, Precision::double_));
  try {
    Simulation(scene, Precision::single_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("fluid.rect.0: found a particle whose velocity is beyond the range"),
        std::string::npos);
  }
}

}  // namespace
}  // namespace sluice::test
