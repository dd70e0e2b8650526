// Density by summation over the neighbours, the particle itself and the boundary [Hunkler 2022, algorithm 5]:
//   rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void density(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto) {
    const auto x_ij = i(state.x) - j(state.x);
    return std::array{kernel(params, square_root(dot(x_ij, x_ij)))};
  };
  sum_over_neighbours(state, std::array{kernel(params, Real(0))}, term, [&](auto i, auto sums) {
    auto rho = params.m * sums[0];
    if (walls) rho += i(state.wall_density);
    i.set(state.rho, rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(density)
