// Source of the pressure system, several particles side by side.
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void source(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto dW) {
    return std::array{dot(i(state.v_star) - j(state.v_star), dW)};
  };
  sum_over_neighbours(state, std::array<Real, 1>{}, term, [&](auto i, auto sums) {
    auto sum = params.m * sums[0];
    if (walls) sum += dot(i(state.v_star), i(state.wall_gradient));
    i.set(state.s, params.source_weight * (params.rho0 - i(state.rho)) - params.dt * sum);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(source)
