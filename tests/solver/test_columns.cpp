// Columns of water, the hard case of a pressure solver: the symmetric wall holds them, whatever their depth
// and viscosity; their pressure is that of water at rest. With the thesis's wall solves end by themselves.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/column.hpp"

namespace sluice::test {
namespace {

TEST(Columns, TheSymmetricWallHoldsThem) {
  for (const uint32_t depth : {30u, 100u}) {
    for (const double nu : {0.0, 200.0}) {
      for (const double lambda : {0.4, 0.8}) expect_held({10, depth, nu, lambda}, sound, 10);
    }
  }
}

// It may be indefinite there: what is asked is that every step ends, with a finite pressure, and says so.
TEST(Columns, WithTheThesissWallEverySolveEnds) {
  const Column column{10, 200, 200, 0.4};
  Simulation simulation(column.load({"pressure.iisph.tolerance=1e-4"}), Precision::single_);
  size_t not_converged = 0;
  for (const StepReport& report : simulation.run(40)) {
    EXPECT_LT(report.residual, 1);
    if (!report.converged) ++not_converged;
  }
  EXPECT_GT(not_converged, 0u);
  EXPECT_FALSE(simulation.simulator->failure());
  for (const double p : simulation.simulator->snapshot().pressure) EXPECT_TRUE(std::isfinite(p));
}

}  // namespace
}  // namespace sluice::test
