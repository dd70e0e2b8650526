// Errors over resolution: orders, limits, and what rounding changes.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace sluice {

/// Particles per unit of length.
inline constexpr int resolutions[] = {20, 40, 80};

/// The error of a quantity by resolution.
struct ErrorCurve {
  std::map<int, double> error;

  /// NaN where it was not run.
  double at(int n) const;
  /// At N = 40, or where that was not run at N = 20.
  double decisive() const;
  /// The slope of the error over the spacing, from the coarsest to the finest; NaN for fewer than two.
  double order() const;
};

struct ErrorKey {
  std::string name, quantity, method, machine;
  auto operator<=>(const ErrorKey&) const = default;
};
using ErrorCurves = std::map<ErrorKey, ErrorCurve>;

/// A table of limits and one of all methods, as Markdown. A limit at N = 40 that is not met is added to
/// `faults`.
std::string validation_page(const ErrorCurves& curves, std::vector<std::string>& faults);

}  // namespace sluice
