// The largest time step of a grid of runs.
#include <gtest/gtest.h>

#include <limits>

#include "studies/timestep.hpp"

namespace sluice::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Three starts; the middle one of each step's cfl decides, and a step may pass above one that does not.
TEST(StepLimit, IsTheLargestStepWhoseMedianPasses) {
  const StepLimit limit = step_limit({{0.1, 0, 0.5},
                                      {0.1, 1, 0.6},
                                      {0.1, 2, infinite},  //
                                      {0.2, 0, 1.1},
                                      {0.2, 1, 0.9},
                                      {0.2, 2, 1.2},  //
                                      {0.3, 0, 1.0, 2},
                                      {0.3, 1, 0.8, 0},
                                      {0.3, 2, 7.0, 5},  //
                                      {0.4, 0, 2.0},
                                      {0.4, 1, 0.9},
                                      {0.4, 2, infinite}});
  EXPECT_EQ(limit.dt, 0.3);
  EXPECT_EQ(limit.lost, 2);
  EXPECT_EQ(limit.steady, 0.1);
  EXPECT_EQ(limit.least, 0);  // the third start passes nowhere
  EXPECT_EQ(limit.most, 0.4);
  EXPECT_FALSE(limit.at_the_end);
}

TEST(StepLimit, SaysWhenTheGridEndsTooSoon) {
  EXPECT_TRUE(step_limit({{0.1, 0, 0.5}, {0.2, 0, 1.0}}).at_the_end);
  EXPECT_EQ(step_limit({{0.1, 0, 1.5}, {0.2, 0, 1.1}}).dt, 0);
}

// Of an even number of starts both in the middle have to pass.
TEST(StepLimit, TakesTheLargerMiddleOfAnEvenNumber) {
  EXPECT_EQ(step_limit({{0.1, 0, 0.5}, {0.1, 1, 1.5}}).dt, 0);
  EXPECT_EQ(step_limit({{0.1, 0, 0.5}, {0.1, 1, 1.0}}).dt, 0.1);
}

TEST(Exponent, IsThatOfAPowerLaw) {
  EXPECT_NEAR(exponent({1, 4, 9}, {2, 1, 2.0 / 3}), -0.5, 1e-12);
  EXPECT_NEAR(exponent({8, 10, 20}, {0.06, 0.075, 0.15}), 1, 1e-12);
}

}  // namespace
}  // namespace sluice::test
