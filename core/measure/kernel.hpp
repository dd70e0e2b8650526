// The kernel for measures, which are taken in double and outside of the stages; cpu/kernel.hpp has the
// stages' own.
#pragma once

#include <algorithm>

#include "core/model/params.hpp"

namespace sluice {

/// The cubic spline in two dimensions [Monaghan 1992] at distance r.
inline double kernel(const Params& params, double r) {
  const double q = r * params.inverse_H, a = std::max(2 - q, 0.0), b = std::max(1 - q, 0.0);
  return params.kernel_factor * (a * a * a - 4 * b * b * b);
}

/// Its gradient with respect to x_i, for x_ij = x_i - x_j of length r.
inline glm::dvec2 kernel_gradient(const Params& params, glm::dvec2 x_ij, double r) {
  if (r == 0) return {};
  const double q = r * params.inverse_H, a = std::max(2 - q, 0.0), b = std::max(1 - q, 0.0);
  return params.gradient_factor * (12 * b * b - 3 * a * a) / r * x_ij;
}

}  // namespace sluice
