// Shapes -> samples: counts and places, double samples, overlaps, jitter, start velocities.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/random.hpp"
#include "sluice/error.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

Scene scene_with(const std::string& shapes, const std::string& fluid_keys = "") {
  return parse_scene(R"(
    [scene]
    title = "shapes"
    [particles]
    spacing = 0.5
    rest_density = 1
    [domain]
    min = [0, 0]
    max = [20, 20]
    [pressure]
    method = "iisph"
    [time]
    dt = 0.01
    duration = 1
    [fluid]
    gravity = [0, -1]
  )" + fluid_keys + "\n" +
                         shapes,
                     "shapes.toml");
}

std::string refusal(const Scene& scene) {
  try {
    sample(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

const std::string small_fluid = "[[fluid.rect]]\nmin = [10, 10]\ncount = [2, 2]\n";

TEST(Sampling, RectExcludesItsMaximumAndGoesRowByRow) {
  const Samples samples = sample(scene_with("[[fluid.rect]]\nmin = [1, 2]\nmax = [2.5, 3]\n"));
  const std::vector<Vec2> expected = {{1, 2}, {1.5, 2}, {2, 2}, {1, 2.5}, {1.5, 2.5}, {2, 2.5}};
  EXPECT_EQ(samples.fluid, expected);
}

TEST(Sampling, LayersKeepTheOuterOnes) {
  const Samples samples = sample(scene_with(small_fluid + R"(
    [boundary]
    model = "mirror"
    [[boundary.rect]]
    min = [1, 1]
    count = [7, 6]
    layers = 2
  )"));
  EXPECT_EQ(samples.boundary.size(), 7u * 6u - 3u * 2u);
}

TEST(Sampling, DiscHoldsItsCentreAndNothingOnItsRim) {
  const Samples samples = sample(scene_with("[[fluid.disc]]\ncentre = [5, 5]\nradius = 2\n"));
  uint32_t at_centre = 0;
  for (const Vec2 x : samples.fluid) {
    EXPECT_LT(glm::length(x - Vec2(5, 5)), 2);
    if (x == Vec2(5, 5)) ++at_centre;
  }
  EXPECT_EQ(at_centre, 1u);
  // Lattice points with i^2 + j^2 < 16.
  EXPECT_EQ(samples.fluid.size(), 45u);
}

TEST(Sampling, PolygonIsFilledStrictlyInside) {
  const Samples samples =
      sample(scene_with("[[fluid.polygon]]\npoints = [[1, 1], [5, 1], [5, 3], [3, 3], [3, 5], [1, 5]]\n"));
  // An L of 7 x 3 points below and 3 x 4 above, edges left out.
  EXPECT_EQ(samples.fluid.size(), 7u * 3u + 3u * 4u);
  for (const Vec2 x : samples.fluid) {
    EXPECT_TRUE(x.x > 1 && x.x < 5 && x.y > 1 && x.y < 5 && (x.x < 3 || x.y < 3)) << x.x << " " << x.y;
  }
}

TEST(Sampling, SegmentHasItsFurtherLayersToTheRight) {
  const Samples samples = sample(scene_with(small_fluid + R"(
    [boundary]
    model = "mirror"
    [[boundary.segment]]
    from = [2, 2]
    to = [4, 2]
    layers = 2
  )"));
  ASSERT_EQ(samples.boundary.size(), 10u);
  for (uint32_t i = 0; i < 10; ++i)
    EXPECT_EQ(samples.boundary[i], Vec2(2 + 0.5 * (i % 5), i < 5 ? 2.0 : 1.5));
}

TEST(Sampling, ContainerWallsStandWhereTheyAreNamed) {
  const Samples samples = sample(scene_with(small_fluid + R"(
    [boundary]
    model = "mirror"
    [[boundary.container]]
    min = [0, 0]
    max = [20, 20]
    layers = 1
    sides = ["left", "right", "bottom", "top"]
  )"));
  // Columns of 41 on both sides, rows of 39 between them.
  EXPECT_EQ(samples.boundary.size(), 2u * 41u + 2u * 39u);
  EXPECT_EQ(samples.boundary_dropped, 0u);
  for (const Vec2 x : samples.boundary) {
    EXPECT_TRUE(x.x == 0 || x.x == 20 || x.y == 0 || x.y == 20) << x.x << " " << x.y;
  }
}

TEST(Sampling, DoubleBoundarySamplesAreDroppedAndCounted) {
  const Samples samples = sample(scene_with(small_fluid + R"(
    [boundary]
    model = "mirror"
    [[boundary.rect]]
    min = [1, 1]
    count = [4, 1]
    [[boundary.rect]]
    min = [2.1, 1.1]
    count = [4, 1]
  )"));
  EXPECT_EQ(samples.boundary_dropped, 2u);  // 2.1 and 2.6, a tenth beside and above 2.0 and 2.5
  EXPECT_EQ(samples.boundary.size(), 6u);
}

TEST(Sampling, FluidTooCloseToABoundaryIsRefusedWithBothPlaces) {
  const std::string message = refusal(scene_with(R"(
    [[fluid.rect]]
    min = [1, 1]
    count = [3, 3]
    [boundary]
    model = "mirror"
    [[boundary.rect]]
    min = [2.2, 1]
    count = [2, 1]
  )"));
  EXPECT_EQ(message,
            "shapes.toml:19:5: fluid.rect.0: found fluid at (2, 1) within half a spacing of boundary.rect.0 "
            "at (2.2, 1), "
            "expected at least h/2 = 0.25 between them");
}

TEST(Sampling, OverlappingFluidIsRefusedWithBothPlaces) {
  const std::string message = refusal(scene_with(R"(
    [[fluid.rect]]
    min = [1, 1]
    count = [3, 3]
    [[fluid.disc]]
    centre = [3.1, 1]
    radius = 1.1
  )"));
  EXPECT_NE(
      message.find("fluid.disc.0: found fluid at (2.1, 1) within half a spacing of fluid.rect.0 at (2, 1)"),
      std::string::npos)
      << message;
}

TEST(Sampling, CoincidingFluidIsRefused) {
  EXPECT_NE(refusal(scene_with(small_fluid + small_fluid))
                .find("within half a spacing of fluid.rect.0 at (10, 10)"),
            std::string::npos);
}

TEST(Sampling, PlacesTooFarFromTheOriginAreRefused) {
  for (const std::string place : {"1e30", "1e17", "-1e13"}) {
    const std::string message =
        refusal(scene_with("[[fluid.rect]]\nmin = [" + place + ", 0]\ncount = [2, 2]\n"));
    EXPECT_NE(message.find("fluid.rect.0: found a sample at"), std::string::npos) << message;
  }
}

TEST(Sampling, ShapeWithoutAParticleIsRefused) {
  EXPECT_NE(refusal(scene_with("[[fluid.polygon]]\npoints = [[1, 1], [1.2, 1], [1.1, 1.2]]\n"))
                .find("found no particle"),
            std::string::npos);
}

TEST(Sampling, JitterIsBoundedSeededAndWrittenOut) {
  const Scene scene =
      scene_with("[[fluid.rect]]\nmin = [1, 1]\ncount = [30, 30]\n", "jitter = 0.2\nseed = 5\n");
  const Samples plain = sample(scene_with("[[fluid.rect]]\nmin = [1, 1]\ncount = [30, 30]\n"));
  const Samples jittered = sample(scene);
  double largest = 0, sum = 0;
  for (size_t i = 0; i < plain.fluid.size(); ++i) {
    const Vec2 offset = (jittered.fluid[i] - plain.fluid[i]) / 0.5;
    for (const double component : {offset.x, offset.y}) {
      largest = std::max(largest, std::abs(component));
      sum += component;
    }
  }
  EXPECT_LE(largest, 0.2);
  EXPECT_GT(largest, 0.19);
  EXPECT_LT(std::abs(sum / 1800), 0.02);
  EXPECT_EQ(sample(scene).fluid, jittered.fluid);
}

// Known first values of SplitMix64 from seed 1234567, so that a seed means the same everywhere.
TEST(Sampling, RandomNumbersAreThePublishedOnes) {
  Random random(1234567);
  for (const uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u}) {
    EXPECT_EQ(random.uniform(), static_cast<double>(expected >> 11) * 0x1p-53);
  }
}

TEST(Sampling, StartVelocityTurnsAboutTheCentreOfTheShape) {
  const std::string keys = "velocity = [1, 2]\nvelocity_gradient = [[0, -3], [3, 0]]\n";
  const Scene rect = scene_with("[[fluid.rect]]\nmin = [1, 1]\ncount = [3, 3]\n" + keys);
  EXPECT_EQ(start_velocity(rect.fluid[0], 0.5, {1.5, 1.5}), Vec2(1, 2));
  EXPECT_EQ(start_velocity(rect.fluid[0], 0.5, {2.5, 1.5}), Vec2(1, 5));
  EXPECT_EQ(start_velocity(rect.fluid[0], 0.5, {1.5, 2.5}), Vec2(-2, 2));
  const Scene polygon = scene_with("[[fluid.polygon]]\npoints = [[0, 0], [6, 0], [6, 3], [0, 3]]\n" + keys);
  EXPECT_EQ(start_velocity(polygon.fluid[0], 0.5, {3, 1.5}), Vec2(1, 2));
}

TEST(Sampling, BoundsAreUpperBounds) {
  for (const std::string& name : shipped_scenes()) {
    const Scene scene = shipped(name);
    const SampleBounds bounds = sample_bounds(scene);
    const Samples samples = sample(scene);
    EXPECT_GE(bounds.fluid, double(samples.fluid.size())) << name;
    EXPECT_GE(bounds.boundary, double(samples.boundary.size())) << name;
    EXPECT_LE(bounds.fluid, 1.5 * double(samples.fluid.size())) << name;
  }
}

}  // namespace
}  // namespace sluice::test
