// What a particle needs of the boundary, summed over the samples in its reach.
#pragma once

#include "cpu/kernel.hpp"
#include "cpu/loops.hpp"

namespace sluice::cpu::SLUICE_SET {

/// The sums, in units of the factors in front of them.
template <class Real>
struct WallSums {
  Real W{}, squares{};
  glm::vec<2, Real> gradient{};
  glm::vec<4, Real> tensor{};
};

template <class Real>
WallSums<Real> wall_sums_at(const State<Real>& state, const ParamsOf<Real>& params, glm::vec<2, Real> x_i) {
  const bool viscous = state.needs.laplacian, pseudo_mass = state.needs.pseudo_mass;
  WallSums<Real> sums;
  for_each_row(state.C_boundary, params.columns, cell_of(params, x_i), [&](uint32_t first, uint32_t last) {
    for (uint32_t b = first; b < last; ++b) {
      const glm::vec<2, Real> x_ib = x_i - state.x_boundary[b];
      const Real r_squared = glm::dot(x_ib, x_ib);
      if (!(r_squared < params.support_squared)) continue;
      const Real r = std::sqrt(r_squared);
      const glm::vec<2, Real> dW = kernel_gradient(params, x_ib, r);
      const Real mass = pseudo_mass ? state.Psi[b] : Real(1);  // in units of params.wall_mass
      sums.W += mass * kernel(params, r);
      sums.gradient += mass * dW;
      sums.squares += glm::dot(dW, dW);
      if (viscous) {
        const glm::vec<2, Real> y = (mass * x_ib) / (r_squared + params.viscosity_floor);
        sums.tensor += glm::vec<4, Real>(dW.x * y.x, dW.x * y.y, dW.y * y.x, dW.y * y.y);
      }
    }
  });
  return sums;
}

/// A function that stores the sums of particle i: set(i, sums).
template <class Real>
auto wall_sums_setter(State<Real>& state, const ParamsOf<Real>& params) {
  const bool viscous = state.needs.laplacian;
  const bool needs_squares = state.needs.thesis_wall;
  return [=, &state, &params](size_t i, const WallSums<Real>& sums) {
    state.wall_density[i] = params.wall_mass * sums.W;
    state.wall_gradient[i] = params.wall_gradient_mass * sums.gradient;
    if (needs_squares) state.wall_gradient_squares[i] = params.m * params.m * sums.squares;
    if (viscous) state.wall_viscosity[i] = params.wall_mass * sums.tensor;
  };
}

}  // namespace sluice::cpu::SLUICE_SET
