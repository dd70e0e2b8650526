// Errors over resolution: orders, limits, and what rounding changes.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "studies/table.hpp"

namespace sluice::study {

/// Particles per unit of length.
inline constexpr int resolutions[] = {20, 40, 80};

/// The error of a quantity by resolution; `invalid_error` where the run became invalid.
struct ErrorCurve {
  std::map<int, double> error;

  /// NaN where it was not run.
  double at(int n) const;
  /// The slope of the error over the spacing, from the coarsest to the finest; NaN for fewer than two.
  double order() const;
};

struct ErrorKey {
  std::string name, quantity, method, machine;
  auto operator<=>(const ErrorKey&) const = default;
};
using ErrorCurves = std::map<ErrorKey, ErrorCurve>;

/// The error of a run that became invalid, or has no value.
inline constexpr double invalid_error = std::numeric_limits<double>::infinity();

struct ValidationTables {
  TextTable limits;      ///< the best method of each quantity that has a limit, and whether it keeps it
  TextTable methods;     ///< all methods, and what rounding changes
  std::string rounding;  ///< the same in words
};

/// A limit at N = 40 that is not kept is added to `faults`.
ValidationTables validation_tables(const ErrorCurves& curves, std::vector<std::string>& faults);

/// As Markdown.
std::string page_of(const ValidationTables& tables);

}  // namespace sluice::study
