// A maximum that does not hide NaN.
#pragma once

namespace sluice {

/// The larger of two values; unlike std::max it keeps a NaN in either place.
template <class Real>
Real larger(Real a, Real b) {
  return b > a || b != b ? b : a;
}

}  // namespace sluice
