// How far two arrays of the same quantity are apart, and whether comparing them proves anything.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/model/fields.hpp"

namespace sluice {

/// Findings of a comparison.
struct Difference {
  double max_abs = 0;  ///< largest |a - b|; infinite where something is not finite or sizes differ
  double max_ulp = 0;  ///< max_abs in units in the last place (of a float) of the reference's largest value
  uint64_t values = 0, equal = 0;
  bool all_zero = true;  ///< the reference holds nothing but zeros

  struct Place {
    Field field = Field::count;
    uint64_t index = 0;
    double reference = 0, other = 0;
  };
  std::optional<Place> first;  ///< the first value that differs

  double equal_share() const { return values == 0 ? 0 : double(equal) / double(values); }
  /// Whether all is equal to within `tolerance_ulp`; with tolerance 0, to the last bit.
  bool within(double tolerance_ulp) const {
    return tolerance_ulp > 0 ? max_ulp <= tolerance_ulp : equal == values;
  }
  /// Whether something was compared, and is within `tolerance_ulp`.
  bool agrees(double tolerance_ulp) const { return values > 0 && !all_zero && within(tolerance_ulp); }

  /// Adds the findings of another comparison.
  void add(const Difference& more);
};

/// Compares values of `field`. Equal means the same bits. NaN and infinity are equal to nothing, nor are
/// arrays of different lengths. Throws std::logic_error for an array compared with itself.
Difference compare(std::span<const double> reference, std::span<const double> other,
                   Field field = Field::count);
Difference compare(std::span<const uint32_t> reference, std::span<const uint32_t> other,
                   Field field = Field::count);

}  // namespace sluice
