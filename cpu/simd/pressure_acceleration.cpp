// Pressure acceleration, several particles side by side.
#include "cpu/simd/partwise.hpp"
#include "cpu/simd/sums.hpp"
#include "cpu/wall.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_acceleration(State<Real>& state, Part part) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto dW) {
    const auto q = i(state.q) + j(state.q);
    return std::array{q * dW.x, q * dW.y};
  };
  sum_over_neighbours(state, part, std::array<Real, 2>{}, term, [&](auto i, auto sums) {
    auto sum = -(params.m * Pair{sums[0], sums[1]});
    if (walls) sum -= wall_pressure_term(params, i(state.q), i(state.rho)) * i(state.wall_gradient);
    i.set(state.a_p, sum);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_PARTWISE_STAGE(pressure_acceleration)
