// Cubic spline kernel in two dimensions and its gradient [Monaghan 1992; Hunkler 2022, eqs. 5.1 and 5.2].
// q = r/H, (z)_+ = max(z, 0):
//   W  = 5/(14 pi H^2) ((2-q)_+^3 - 4 (1-q)_+^3)
//   dW = 5/(14 pi H^3) (-3 (2-q)_+^2 + 12 (1-q)_+^2) x_ij/r, zero at r = 0
#pragma once

#include <cmath>

#include "core/params.hpp"

namespace sluice::cpu {

/// W at distance r; 1/length^2.
template <class Real>
Real kernel(const ParamsOf<Real>& params, Real r) {
  const Real q = r * params.inverse_H;
  const Real t1 = std::max(Real(1) - q, Real(0));
  const Real t2 = std::max(Real(2) - q, Real(0));
  return params.kernel_factor * (t2 * t2 * t2 - Real(4) * (t1 * t1 * t1));
}

/// dW with respect to x_i for x_ij = x_i - x_j of length r; 1/length^3.
template <class Real>
glm::vec<2, Real> kernel_gradient(const ParamsOf<Real>& params, glm::vec<2, Real> x_ij, Real r) {
  const Real q = r * params.inverse_H;
  const Real t1 = std::max(Real(1) - q, Real(0));
  const Real t2 = std::max(Real(2) - q, Real(0));
  const Real inverse_r = r > Real(0) ? Real(1) / r : Real(0);
  const Real slope = params.gradient_factor * (Real(12) * (t1 * t1) - Real(3) * (t2 * t2));
  return (slope * inverse_r) * x_ij;
}

}  // namespace sluice::cpu
