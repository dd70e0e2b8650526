// Lengths as scene files write them: "a", "bh", "a+bh" or "a-bh", with h the particle spacing.
#pragma once

#include <optional>
#include <string_view>

namespace sluice {

/// The length a + b h.
struct LengthInSpacings {
  double a = 0;
  double b = 0;
  double value(double h) const { return b == 0 ? a : a + b * h; }
};

/// Reads one of the four forms; a and b are decimal numbers, without spaces, and only the first may carry a
/// minus sign of its own. Nothing when the text has another form or a number is beyond the range of double.
std::optional<LengthInSpacings> parse_length(std::string_view text);

}  // namespace sluice
