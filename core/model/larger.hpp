// A maximum that does not hide NaN.
#pragma once

namespace sluice {

/// The larger of two values; unlike std::max it keeps a NaN in either place.
template <class Real>
Real larger(Real a, Real b) {
  return b > a || b != b ? b : a;
}

/// `value`, or `least` where it is below that. `least` is no NaN; a NaN value is kept. Processors have an
/// instruction for this, and none for larger().
template <class Real>
Real at_least(Real least, Real value) {
  return least >= value ? least : value;
}

}  // namespace sluice
