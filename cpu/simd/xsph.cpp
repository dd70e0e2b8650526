// XSPH, several particles side by side.
#include "cpu/kernel.hpp"
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void xsph(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const auto term = [&](auto i, auto j, auto) {
    const auto x_ij = i(state.x) - j(state.x), v_ij = i(state.v) - j(state.v);
    const auto weight = kernel(params, square_root(dot(x_ij, x_ij))) / j(state.rho);
    return std::array{weight * v_ij.x, weight * v_ij.y};
  };
  const auto finish = [&](auto i, auto sums) {
    i.set(state.a_n, i(state.a_n) - params.xsph * Pair{sums[0], sums[1]});
  };
  sum_over_neighbours(state, std::array<Real, 2>{}, term, finish, NoPrefetch{});
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(xsph)
