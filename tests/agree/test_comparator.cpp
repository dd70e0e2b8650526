// The comparator that all agreement between CPU and GPU rests on: it sees every kind of difference, and
// refuses what proves nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/agree/comparison.hpp"

namespace sluice::test {
namespace {

constexpr double loose = 1e6;  // units in the last place; what fails even so does not fail by its size

std::vector<double> some_values() {
  std::vector<double> values(300);
  for (size_t i = 0; i < values.size(); ++i) values[i] = double(float(std::sin(0.1 * double(i)) + 2));
  return values;
}

TEST(Comparator, EqualArraysAgree) {
  const std::vector<double> a = some_values(), b = a;
  const Difference found = compare(a, b);
  EXPECT_TRUE(found.agrees(0));
  EXPECT_EQ(found.equal_share(), 1);
  EXPECT_EQ(found.max_abs, 0);
  EXPECT_FALSE(found.first);
}

TEST(Comparator, SeesOneValueOffByOneUnitInTheLastPlace) {
  for (const size_t at : {size_t{0}, size_t{150}, size_t{299}}) {
    const std::vector<double> a = some_values();
    std::vector<double> b = a;
    b[at] = double(std::nextafter(float(a[at]), 10.0f));
    const Difference found = compare(a, b, Field::rho);
    EXPECT_FALSE(found.agrees(0));
    EXPECT_EQ(found.equal, 299u);
    ASSERT_TRUE(found.first);
    EXPECT_EQ(found.first->index, at);
    EXPECT_EQ(found.first->field, Field::rho);
    EXPECT_EQ(found.first->reference, a[at]);
    EXPECT_EQ(found.first->other, b[at]);
    // The largest value lies in [2, 4), where units are 2^-22; those of smaller values are as large or
    // smaller.
    EXPECT_LE(found.max_ulp, 1);
    EXPECT_GE(found.max_ulp, 0.25);
    EXPECT_TRUE(found.agrees(1));
    EXPECT_FALSE(found.agrees(0.2));
  }
}

TEST(Comparator, MeasuresInUnitsOfTheLargestValue) {
  const std::vector<double> a{1024, 1e-3}, b{1024, 2e-3};
  EXPECT_DOUBLE_EQ(compare(a, b).max_ulp, 1e-3 / std::ldexp(1.0, 10 - 23));
  EXPECT_DOUBLE_EQ(compare(a, b).max_abs, 1e-3);
}

TEST(Comparator, NothingThatIsNotFiniteAgrees) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {nan, infinity, -infinity}) {
    std::vector<double> a = some_values(), b = a;
    b[7] = wrong;
    EXPECT_FALSE(compare(a, b).agrees(loose)) << wrong << " in the other";
    EXPECT_FALSE(compare(b, a).agrees(loose)) << wrong << " in the reference";
    a[7] = wrong;
    EXPECT_FALSE(compare(a, b).agrees(0)) << wrong << " in both";
    EXPECT_FALSE(compare(a, b).agrees(loose)) << wrong << " in both";
    EXPECT_EQ(compare(a, b).first->index, 7u);
  }
}

TEST(Comparator, SeesASwappedPair) {
  const std::vector<double> a = some_values();
  std::vector<double> b = a;
  std::swap(b[10], b[20]);
  EXPECT_FALSE(compare(a, b).agrees(1));
  EXPECT_EQ(compare(a, b).equal, 298u);
}

TEST(Comparator, SeesAShortArray) {
  const std::vector<double> a = some_values();
  for (const size_t length : {size_t{0}, size_t{1}, a.size() - 1}) {
    const std::vector<double> shorter(a.begin(), a.begin() + static_cast<int64_t>(length));
    EXPECT_FALSE(compare(a, shorter).agrees(loose)) << length;
    EXPECT_FALSE(compare(shorter, a).agrees(loose)) << length;
    EXPECT_EQ(compare(a, shorter).first->index, length);
  }
  EXPECT_FALSE(compare(std::vector<double>{}, std::vector<double>{}).agrees(loose)) << "nothing was compared";
}

TEST(Comparator, RefusesAnArrayComparedWithItself) {
  const std::vector<double> a = some_values();
  EXPECT_THROW(compare(a, a), std::logic_error);
  const std::vector<uint32_t> b{1, 2, 3};
  EXPECT_THROW(compare(b, b), std::logic_error);
}

TEST(Comparator, AReferenceOfZerosProvesNothing) {
  const std::vector<double> zeros(300), b = zeros;
  EXPECT_TRUE(compare(zeros, b).all_zero);
  EXPECT_FALSE(compare(zeros, b).agrees(0));
  EXPECT_FALSE(compare(zeros, some_values()).agrees(loose));
  const std::vector<double> negative(300, -0.0);
  EXPECT_FALSE(compare(zeros, negative).within(0)) << "the two zeros are different bits";
}

TEST(Comparator, IntegersHaveNoTolerance) {
  std::vector<uint32_t> a(300);
  std::iota(a.begin(), a.end(), 0u);
  std::vector<uint32_t> b = a;
  EXPECT_TRUE(compare(a, b).agrees(0));
  b[299] = 298;
  EXPECT_FALSE(compare(a, b).agrees(loose));
  EXPECT_EQ(compare(a, b).max_abs, 1);
}

TEST(Comparator, SumsUpWhatSeveralComparisonsFound) {
  const std::vector<double> a = some_values(), zeros(5), more_zeros(5);
  std::vector<double> b = a, c = a;
  c[3] += 1;
  Difference found = compare(zeros, more_zeros, Field::q);
  EXPECT_TRUE(found.all_zero);
  found.add(compare(a, b, Field::p));
  EXPECT_TRUE(found.agrees(0));
  found.add(compare(a, c, Field::rho));
  EXPECT_FALSE(found.agrees(0));
  EXPECT_EQ(found.values, 605u);
  EXPECT_EQ(found.equal, 604u);
  EXPECT_EQ(found.first->field, Field::rho);
}

}  // namespace
}  // namespace sluice::test
