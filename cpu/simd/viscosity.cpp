// Laplacian viscosity, several particles side by side.
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void viscosity(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto dW) {
    const auto x_ij = i(state.x) - j(state.x);
    const auto approach = dot(i(state.v) - j(state.v), x_ij);
    const auto factor = approach / ((dot(x_ij, x_ij) + params.viscosity_floor) * j(state.rho));
    return std::array{factor * dW.x, factor * dW.y};
  };
  sum_over_neighbours(state, std::array<Real, 2>{}, term, [&](auto i, auto sums) {
    auto sum = params.m * Pair{sums[0], sums[1]};
    if (walls) {
      const auto v_i = i(state.v);
      const auto t = i(state.wall_viscosity);
      sum += Pair{t.x * v_i.x + t.y * v_i.y, t.z * v_i.x + t.w * v_i.y} / i(state.rho);
    }
    i.set(state.a_n, i(state.a_n) + (Real(2) * params.nu) * sum);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(viscosity)
