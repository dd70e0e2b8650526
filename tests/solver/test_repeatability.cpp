// The same run gives the same bits: twice, and on 1, 2, 3 and 4 threads, in float and in double, through the
// impact.
#include <gtest/gtest.h>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

struct Outcome {
  Snapshot snapshot;
  std::vector<uint32_t> iterations;
  std::vector<double> residuals, energies;
  bool operator==(const Outcome& other) const {
    return same_bits(snapshot, other.snapshot) && iterations == other.iterations &&
           residuals == other.residuals && energies == other.energies;
  }
};

Outcome outcome(const Scene& scene, Precision precision, int threads, uint64_t steps) {
  Simulation simulation(scene, precision, threads);
  Outcome result;
  for (const StepReport& report : simulation.run(steps)) {
    result.iterations.push_back(report.iterations);
    result.residuals.push_back(report.residual);
    result.energies.push_back(report.diagnostics.kinetic_energy);
  }
  result.snapshot = simulation.simulator->snapshot();
  return result;
}

class Repeatability : public testing::TestWithParam<std::string> {};

TEST_P(Repeatability, AnyNumberOfThreadsGivesTheSameBits) {
  // Fine enough for every thread to get its share of the particles.
  const Scene scene =
      shipped("breaking_dam", {"particles.spacing=2.5", "viscosity.coefficient=50",
                               "pressure.method=" + GetParam(), "time.dt=0.003", "fluid.jitter=0.05"});
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const Outcome one = outcome(scene, precision, 1, 60);
    for (const int threads : {1, 2, 3, 4}) EXPECT_EQ(outcome(scene, precision, threads, 60), one) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Repeatability, testing::Values("iisph", "ssph", "wcsph"));

TEST(RepeatabilityTest, ThroughTheImpact) {
  const Scene scene =
      shipped("breaking_dam", {"particles.spacing=4", "viscosity.coefficient=100", "time.dt=0.02"});
  EXPECT_EQ(outcome(scene, Precision::double_, 4, 500), outcome(scene, Precision::double_, 1, 500));
}

TEST(RepeatabilityTest, FloatAndDoubleAreNotTheSame) {
  const Scene scene = shipped("breaking_dam");
  EXPECT_FALSE(outcome(scene, Precision::double_, 1, 10) == outcome(scene, Precision::single_, 1, 10));
}

}  // namespace
}  // namespace sluice::test
