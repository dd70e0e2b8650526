// Particles that coincide, or nearly do, part: along a fixed direction, the same way on both backends, by
// their ids and not by chance, and without momentum from nowhere.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/context.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// A block of fluid without gravity in which particle 300 was moved to particle 100, or near it.
struct Pair {
  static constexpr uint32_t a = 100, b = 300;
  Scene scene;
  Samples samples;

  explicit Pair(Vec2 distance_in_h, const std::string& method = "iisph", bool swapped = false)
      : scene(shipped("breaking_dam", {"pressure.method=" + method, "fluid.gravity=[0,0]",
                                       "boundary.container=[]", "viscosity.coefficient=0"})),
        samples(sample(scene)) {
    samples.fluid[b] = samples.fluid[a] + scene.spacing * distance_in_h;
    if (swapped) std::swap(samples.fluid[a], samples.fluid[b]);
  }
  double h() const { return scene.spacing; }
};

Snapshot after(const Pair& pair, Backend& backend, int steps) {
  Simulator simulator(pair.scene, pair.samples, backend);
  for (int step = 0; step < steps; ++step) simulator.step();
  EXPECT_FALSE(simulator.failure());
  return simulator.snapshot();
}

const std::vector<Vec2> distances{{0, 0}, {1e-12, 0}, {0, -1e-6}, {6e-5, 6e-5}, {1e-3, 0}, {0, 1e-3}};

TEST(Coincident, PairsPart) {
  for (const std::string method : {"iisph", "ssph"}) {
    for (const Vec2 distance : distances) {
      SCOPED_TRACE(testing::Message() << method << " " << distance.x << " " << distance.y);
      for (const Precision precision : {Precision::single_, Precision::double_}) {
        const Snapshot state = after(Pair(distance, method), *cpu::make_backend(precision, 1), 60);
        // From 1e-4 h on the kernel's own gradient, hardly there, parts them, and takes longer.
        const bool close = glm::length(distance) < 1e-4;
        EXPECT_GT(glm::length(state.x[Pair::a] - state.x[Pair::b]) / 8, close ? 0.5 : 0.1);
      }
    }
  }
}

TEST(Coincident, TheLargerIdGoesAheadAndTheSmallerBack) {
  for (const bool swapped : {false, true}) {
    const Pair pair({0, 0}, "ssph", swapped);
    const Snapshot state = after(pair, *cpu::make_backend(Precision::double_, 1), 1);
    const Vec2 apart = state.v[Pair::b] - state.v[Pair::a];
    EXPECT_GT(glm::length(apart), 0);
    EXPECT_NEAR(glm::dot(apart, Vec2(0.8, 0.6)), glm::length(apart), 1e-9 * glm::length(apart));
  }
}

TEST(Coincident, MomentumIsConserved) {
  const Snapshot state = after(Pair({0, 0}, "ssph"), *cpu::make_backend(Precision::double_, 1), 10);
  Vec2 momentum{};
  double size = 0;
  for (const Vec2 v : state.v) {
    momentum += v;
    size += glm::length(v);
  }
  EXPECT_GT(size, 0);
  EXPECT_LT(glm::length(momentum), 1e-12 * size);
}

TEST(Coincident, AStepEqualsTheEquations) {
  for (const std::string method : {"iisph", "ssph"}) {
    for (const Vec2 distance : distances) {
      Pair pair(distance, method);
      for (FluidShape& shape : pair.scene.fluid) shape.velocity_gradient = {{0.02, -0.01}, {0.03, -0.02}};
      const auto backend = cpu::make_backend(Precision::double_, 1);
      BruteForce reference(pair.scene, pair.samples);
      reference.step();
      const Snapshot state = after(pair, *backend, 1);
      EXPECT_LT(relative_difference(state.pressure, reference.p), 1e-11);
      EXPECT_LT(relative_difference(state.v, reference.v), 1e-11);
    }
  }
}

TEST(Coincident, BothBackendsPartThemAlike) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  Gpu gpu;
  for (const std::string method : {"iisph", "ssph"}) {
    for (const Vec2 distance : distances) {
      const Pair pair(distance, method);
      const Snapshot on_gpu = after(pair, *gpu.backend, 12);
      for (const auto instructions : {cpu::Instructions::baseline, cpu::widest_instructions()}) {
        const Snapshot on_cpu = after(pair, *cpu::make_backend(Precision::single_, 2, instructions), 12);
        EXPECT_EQ(on_gpu.x, on_cpu.x);
        EXPECT_EQ(on_gpu.v, on_cpu.v);
        EXPECT_EQ(on_gpu.pressure, on_cpu.pressure);
      }
    }
  }
}

// Many in one place, and lists of different lengths beside each other.
TEST(Coincident, AHandfulInOnePlacePartsAlikeToo) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  Pair pair({0, 0}, "ssph");
  for (uint32_t i = 200; i < 206; ++i) pair.samples.fluid[i] = pair.samples.fluid[100];
  Gpu gpu;
  const Snapshot on_gpu = after(pair, *gpu.backend, 10);
  EXPECT_EQ(on_gpu.x, after(pair, *cpu::make_backend(Precision::single_, 2), 10).x);
  EXPECT_EQ(on_gpu.x,
            after(pair, *cpu::make_backend(Precision::single_, 1, cpu::Instructions::baseline), 10).x);
  for (uint32_t i = 200; i < 206; ++i) EXPECT_NE(on_gpu.x[i], on_gpu.x[100]);
}

}  // namespace
}  // namespace sluice::test
