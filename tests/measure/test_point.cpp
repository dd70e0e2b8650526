// Values at a point: exact for linear fields, also beside a wall; levels and fronts; what is too little
// fluid.
#include <gtest/gtest.h>

#include "core/measure/point.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// Fluid at these places with p = 3 + 2x - 5y, v = (x, 1 - y), rho = rho0.
Snapshot linear_at(const Scene& scene, const std::vector<Vec2>& places) {
  Snapshot state;
  for (const Vec2 x : places) {
    state.x.push_back(x);
    state.v.push_back({x.x, 1 - x.y});
    state.pressure.push_back(3 + 2 * x.x - 5 * x.y);
    state.density.push_back(scene.rest_density);
  }
  return state;
}

std::vector<Vec2> block(double h, int columns, int rows, Vec2 corner = {}) {
  std::vector<Vec2> places;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) places.push_back(corner + h * Vec2(i, j));
  return places;
}

TEST(Point, OfALinearFieldItIsExactInsideAtWallsAndInCorners) {
  const Scene scene = shipped("breaking_dam");
  const double h = scene.spacing;
  const Snapshot state = linear_at(scene, block(h, 20, 20));
  for (const Vec2 at :
       {Vec2(9.3, 8.1), Vec2(-0.5, 7.77), Vec2(6.2, -0.5), Vec2(-0.4, -0.4), Vec2(19.5, 19.3)}) {
    const PointValues there = values_at(scene, state, h * at);
    EXPECT_NEAR(there.pressure, 3 + 2 * h * at.x - 5 * h * at.y, 1e-9 * 100 * h) << at.x << ' ' << at.y;
    EXPECT_NEAR(there.velocity.x, h * at.x, 1e-9 * 20 * h);
    EXPECT_NEAR(there.velocity.y, 1 - h * at.y, 1e-9 * 20 * h);
    EXPECT_NEAR(there.density, scene.rest_density, 1e-12);
  }
}

// Hydrostatic pressure where people measure it: on the wall, half a spacing before the first particle.
TEST(Point, HydrostaticPressureAtAWallComesOutWithinAPercentOnDisorderedParticles) {
  const Scene scene = shipped("breaking_dam", {"fluid.jitter=0.2"});
  const double h = scene.spacing, depth = 240;
  Snapshot state;
  for (const Vec2 x : sample(scene).fluid) {
    state.x.push_back(x);
    state.v.push_back({});
    state.pressure.push_back(9.81 * (3 * h + depth - x.y));
    state.density.push_back(1);
  }
  for (const double y : {3.5 * h, 60.0, 130.0, 200.0}) {
    const double expected = 9.81 * (3 * h + depth - y);
    EXPECT_NEAR(values_at(scene, state, {2.5 * h, y}).pressure, expected, 0.01 * expected);
  }
}

TEST(Point, FewParticlesOrAllOnALineGiveTheirWeightedMean) {
  const Scene scene = shipped("breaking_dam");
  const double h = scene.spacing;
  const Snapshot one = linear_at(scene, {{0, 0}});
  EXPECT_DOUBLE_EQ(values_at(scene, one, {h, 0}).pressure, 3);
  const Snapshot line = linear_at(scene, {{0, 0}, {h, 0}, {2 * h, 0}});
  EXPECT_DOUBLE_EQ(values_at(scene, line, {h, 0.3 * h}).pressure, 3 + 2 * h);
  const double between = values_at(scene, line, {0.2 * h, h}).pressure;
  EXPECT_TRUE(between > 3 && between < 3 + 4 * h) << between;
  const PointValues nothing = values_at(scene, line, {0, 3 * h});
  EXPECT_EQ(nothing.pressure, 0);
  EXPECT_EQ(nothing.density, 0);
}

TEST(Point, LevelAndFrontAreHalfASpacingBeyondTheOutermostParticles) {
  const Scene scene = shipped("breaking_dam");
  const double h = scene.spacing;
  std::vector<Vec2> places = block(h, 12, 9, {100, 50});
  const Snapshot block_alone = linear_at(scene, places);
  EXPECT_NEAR(level_at(scene, block_alone, 100 + 5 * h).value(), 50 + 8.5 * h, 0.05 * h);
  EXPECT_NEAR(front_at(scene, block_alone, 50 + 4 * h).value(), 100 + 11.5 * h, 0.05 * h);
  places.push_back({100 + 5 * h, 300});  // a drop of one particle
  EXPECT_NEAR(level_at(scene, linear_at(scene, places), 100 + 5 * h).value(), 50 + 8.5 * h, 0.05 * h);
  EXPECT_FALSE(level_at(scene, block_alone, 0));
  EXPECT_FALSE(front_at(scene, block_alone, 400));
}

TEST(Point, TheFluidsShareIsOneInsideAndAHalfAtTheSurface) {
  const Scene scene = shipped("breaking_dam");
  const double h = scene.spacing;
  const Snapshot state = linear_at(scene, block(h, 20, 20));
  EXPECT_NEAR(share_at(scene, state, h * Vec2(10, 10)), 1, 0.01);
  EXPECT_NEAR(share_at(scene, state, h * Vec2(10, 19.5)), 0.5, 0.02);
  EXPECT_EQ(share_at(scene, state, h * Vec2(10, 22)), 0);
}

}  // namespace
}  // namespace sluice::test
