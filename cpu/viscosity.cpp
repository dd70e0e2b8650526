// Laplacian viscosity [Hunkler 2022, algorithm 8]:
//   a_n += 2 nu ( m sum_j (1/rho_j) (v_ij.x_ij)/(x_ij.x_ij + 0.01 H^2) dW_ij
//               + (1/rho_i) sum_b m_b (v_i.x_ib)/(x_ib.x_ib + 0.01 H^2) dW_ib )
// The sum over b stands in wall_viscosity. Not antisymmetric in i and j because of 1/rho_j, so it does not
// conserve momentum exactly.
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

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
