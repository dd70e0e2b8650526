// Cubic spline kernel in two dimensions and its gradient [Monaghan 1992; Hunkler 2022, eqs. 5.1 and 5.2].
// q = r/H, (z)_+ = max(z, 0):
//   W  = 5/(14 pi H^2) ((2-q)_+^3 - 4 (1-q)_+^3)
//   dW = 5/(14 pi H^3) (-3 (2-q)_+^2 + 12 (1-q)_+^2) x_ij/r, zero at r = 0
// Value is Real; in cpu/simd also a register of them, whose lanes belong to particles.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// max(value, 0), which keeps a NaN.
template <class Value>
Value positive_part(Value value) {
  return Value{} >= value ? Value{} : value;
}

/// W at distance r; 1/length^2.
template <class Real, class Value>
Value kernel(const ParamsOf<Real>& params, Value r) {
  const Value q = r * params.inverse_H;
  const Value t1 = positive_part(Real(1) - q);
  const Value t2 = positive_part(Real(2) - q);
  return params.kernel_factor * (t2 * t2 * t2 - Real(4) * (t1 * t1 * t1));
}

/// Times x_ij this is dW, for x_ij of length r; 1/length^4.
template <class Real, class Value>
Value kernel_slope(const ParamsOf<Real>& params, Value r) {
  const Value q = r * params.inverse_H;
  const Value t1 = positive_part(Real(1) - q);
  const Value t2 = positive_part(Real(2) - q);
  const Value inverse_r = r > Value{} ? Real(1) / r : Value{};
  return params.gradient_factor * (Real(12) * (t1 * t1) - Real(3) * (t2 * t2)) * inverse_r;
}

/// dW with respect to x_i for x_ij = x_i - x_j of length r; 1/length^3.
template <class Real>
glm::vec<2, Real> kernel_gradient(const ParamsOf<Real>& params, glm::vec<2, Real> x_ij, Real r) {
  return kernel_slope(params, r) * x_ij;
}

}  // namespace sluice::cpu::SLUICE_SET
