// Reductions: every value once, in a fixed tree of groups of 64.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/scene/random.hpp"
#include "cpu/fold.hpp"

namespace sluice::test {
namespace {

const auto sum = [](auto a, auto b) { return a + b; };

/// The tree written the other way round: whole levels, from the leaves up.
float by_levels(std::vector<float> values) {
  while (values.size() > 1) {
    std::vector<float> next;
    for (size_t first = 0; first < values.size(); first += 64) {
      float part = values[first];
      for (size_t i = first + 1; i < std::min(first + 64, values.size()); ++i) part += values[i];
      next.push_back(part);
    }
    values = next;
  }
  return values.empty() ? 0.0f : values[0];
}

TEST(Fold, EveryValueIsCountedOnceAtAwkwardSizes) {
  for (const uint64_t n : {0u, 1u, 2u, 63u, 64u, 65u, 128u, 4095u, 4096u, 4097u, 300000u}) {
    const std::vector<double> ones(n, 1.0);
    EXPECT_EQ(cpu::fold(ones.data(), n, sum), static_cast<double>(n)) << n;
  }
}

TEST(Fold, IsTheTreeOfSixtyFours) {
  for (const uint64_t n : {1u, 63u, 65u, 4095u, 4097u, 300000u}) {
    std::vector<float> values;
    Random random(n);
    for (uint64_t i = 0; i < n; ++i) values.push_back(static_cast<float>(random.uniform()));
    EXPECT_EQ(cpu::fold(values.data(), n, sum), by_levels(values)) << n;
  }
}

TEST(Fold, LargestIsFoundAnywhere) {
  for (const uint64_t at : {0u, 63u, 64u, 4999u}) {
    std::vector<double> values(5000, -1.0);
    values[at] = 3;
    EXPECT_EQ(cpu::fold(values.data(), 5000, [](double a, double b) { return std::max(a, b); }), 3);
  }
}

TEST(Fold, LargerKeepsNaN) {
  const double nan = std::nan("");
  EXPECT_EQ(larger(1.0, 2.0), 2);
  EXPECT_EQ(larger(2.0, 1.0), 2);
  EXPECT_TRUE(std::isnan(larger(1.0, nan)));
  EXPECT_TRUE(std::isnan(larger(nan, 1.0)));
  std::vector<double> values(5000, 1.0);
  values[4321] = nan;
  EXPECT_TRUE(std::isnan(cpu::fold(values.data(), 5000, larger<double>)));
}

}  // namespace
}  // namespace sluice::test
