// The comparison other tests rely on fails where it has to.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

const std::vector<double> reference = {1, -4, 2, 0};

std::vector<double> with(size_t index, double value) {
  std::vector<double> changed = reference;
  changed[index] = value;
  return changed;
}

TEST(Comparison, EqualArraysDoNotDiffer) {
  EXPECT_EQ(relative_difference(std::vector<double>(reference), reference), 0);
}

TEST(Comparison, OneElementOffIsSeenRelativeToTheLargest) {
  EXPECT_DOUBLE_EQ(relative_difference(with(3, 1e-3), reference), 1e-3 / 4);
}

TEST(Comparison, NotFiniteIsInfinitelyFar) {
  EXPECT_TRUE(std::isinf(relative_difference(with(2, std::nan("")), reference)));
  EXPECT_TRUE(std::isinf(relative_difference(with(2, std::numeric_limits<double>::infinity()), reference)));
  EXPECT_TRUE(std::isinf(relative_difference(std::vector<double>(reference), with(2, std::nan("")))));
}

TEST(Comparison, SwappedPairIsSeen) {
  EXPECT_GT(relative_difference(std::vector<double>{-4, 1, 2, 0}, reference), 1);
}

TEST(Comparison, ShortArraySameStorageAndZeroReferenceAreInfinitelyFar) {
  EXPECT_TRUE(std::isinf(relative_difference(std::vector<double>{1, -4, 2}, reference)));
  EXPECT_TRUE(std::isinf(relative_difference(reference, reference)));
  EXPECT_TRUE(std::isinf(relative_difference(std::vector<double>(4), std::vector<double>(4))));
}

TEST(Comparison, SnapshotsWithOneBitOffAreNotTheSame) {
  Snapshot a{{{1, 2}}, {{3, 4}}, {5}, {6}, 1}, b = a;
  EXPECT_TRUE(same_bits(a, b));
  b.v[0].y = std::nextafter(4.0, 5.0);
  EXPECT_FALSE(same_bits(a, b));
  b = a;
  b.pressure.clear();
  EXPECT_FALSE(same_bits(a, b));
}

}  // namespace
}  // namespace sluice::test
