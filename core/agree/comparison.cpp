// The comparison, for reals and integers.
#include "core/agree/comparison.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace sluice {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance from a float of this size to the next.
double float_ulp(double value) {
  const int exponent = std::max(std::ilogb(value), std::numeric_limits<float>::min_exponent - 1);
  return std::ldexp(1.0, exponent - (std::numeric_limits<float>::digits - 1));
}

bool same_bits(double a, double b) { return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b); }
bool same_bits(uint32_t a, uint32_t b) { return a == b; }

template <class T>
Difference compare_values(std::span<const T> reference, std::span<const T> other, Field field) {
  if (reference.data() == other.data() && !reference.empty())
    throw std::logic_error("an array is compared with itself");
  Difference result;
  result.values = std::max(reference.size(), other.size());
  double largest = 0;
  const auto note = [&](uint64_t index, double a, double b) {
    const double apart = std::abs(a - b);
    result.max_abs = apart <= result.max_abs ? result.max_abs : std::isfinite(apart) ? apart : infinity;
    if (!result.first) result.first = Difference::Place{field, index, a, b};
  };
  for (size_t i = 0; i < std::min(reference.size(), other.size()); ++i) {
    const auto a = static_cast<double>(reference[i]), b = static_cast<double>(other[i]);
    if (a != 0) result.all_zero = false;
    largest = std::max(largest, std::abs(a));
    if (same_bits(reference[i], other[i]) && std::isfinite(a))
      ++result.equal;
    else
      note(i, a, b);
  }
  if (reference.size() != other.size()) {
    const size_t end = std::min(reference.size(), other.size());
    const auto at = [&](std::span<const T> values) {
      return end < values.size() ? static_cast<double>(values[end]) : std::nan("");
    };
    note(end, at(reference), at(other));
  }
  // Integers have no last place to be off by: any difference is beyond every tolerance.
  const double ulp = std::is_same_v<T, uint32_t> || largest == 0 ? 0 : float_ulp(largest);
  const bool differs = result.equal < result.values;
  result.max_ulp = !differs ? 0 : ulp > 0 && std::isfinite(ulp) ? result.max_abs / ulp : infinity;
  return result;
}

}  // namespace

void Difference::add(const Difference& more) {
  max_abs = std::max(max_abs, more.max_abs);
  max_ulp = std::max(max_ulp, more.max_ulp);
  values += more.values;
  equal += more.equal;
  all_zero = all_zero && more.all_zero;
  if (!first) first = more.first;
}

Difference compare(std::span<const double> reference, std::span<const double> other, Field field) {
  return compare_values(reference, other, field);
}

Difference compare(std::span<const uint32_t> reference, std::span<const uint32_t> other, Field field) {
  return compare_values(reference, other, field);
}

}  // namespace sluice
