// The kernel is a kernel: unit integral, compact support, and a gradient that is its derivative.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cpu/kernel.hpp"
#include "sluice/scene.hpp"

namespace sluice::test {
namespace {

constexpr double H = 1.3;

Params params_with(double h, double smoothing) {
  Scene scene;
  scene.spacing = h;
  scene.smoothing = smoothing;
  scene.rest_density = 2;
  scene.domain_max = {10 * h, 10 * h};
  return make_params(scene, 1);
}

const Params params = params_with(1, H);

TEST(Kernel, IntegratesToOne) {
  double sum = 0;
  const double step = 2 * H / 20000;
  for (int i = 0; i < 20000; ++i) {
    const double r = (i + 0.5) * step;
    sum += 2 * std::numbers::pi * r * cpu::kernel(params, r) * step;
  }
  EXPECT_NEAR(sum, 1, 1e-8);
}

TEST(Kernel, EndsAtTwoSmoothingLengths) {
  EXPECT_GT(cpu::kernel(params, 2 * H * 0.999), 0);
  for (const double r : {2 * H, 2.1 * H, 100 * H}) {
    EXPECT_EQ(cpu::kernel(params, r), 0) << r;
    EXPECT_EQ(glm::length(cpu::kernel_gradient(params, {r, 0.0}, r)), 0) << r;
  }
}

TEST(Kernel, GradientIsTheDerivative) {
  const double step = 1e-6 * H;
  const auto W = [](glm::dvec2 x) { return cpu::kernel(params, glm::length(x)); };
  const double scale = W({0, 0}) / H;
  for (double r = 0.05 * H; r < 2.2 * H; r += 0.05 * H) {
    const glm::dvec2 x = r * glm::dvec2(std::cos(0.7), std::sin(0.7)), dx(step, 0), dy(0, step);
    const glm::dvec2 difference((W(x + dx) - W(x - dx)) / (2 * step), (W(x + dy) - W(x - dy)) / (2 * step));
    EXPECT_LT(glm::length(difference - cpu::kernel_gradient(params, x, r)), 1e-8 * scale) << r / H;
  }
}

TEST(Kernel, GradientVanishesAtZeroAndIsAntisymmetric) {
  EXPECT_EQ(cpu::kernel_gradient(params, {0.0, 0.0}, 0.0), glm::dvec2(0, 0));
  const glm::dvec2 x(0.4, -0.9);
  const double r = glm::length(x);
  EXPECT_EQ(cpu::kernel_gradient(params, x, r), -cpu::kernel_gradient(params, -x, r));
}

// Known value: the sum over a square lattice with H = h, times the particle mass.
TEST(Kernel, LatticeDensityIsTheKnownOne) {
  const Params lattice = params_with(0.5, 1);
  double sum = 0;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) sum += cpu::kernel(lattice, 0.5 * std::hypot(i, j));
  }
  EXPECT_NEAR(lattice.m * sum / lattice.rho0, 1.000862, 1e-6);
}

}  // namespace
}  // namespace sluice::test
