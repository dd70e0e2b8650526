// Pressure acceleration, symmetric in i and j [Hunkler 2022, algorithm 7; WCSPH page]. With q = p/rho^2 and
// B_i the sum over the boundary (stage `boundary`):
//   a_p = -m sum_j (q_i + q_j) dW_ij - (q_i + p_i/rho0^2) B_i
// p_i/rho0^2 stands for a sample that mirrors the pressure of the particle that looks at it; samples with
// pseudo-masses do not [Akinci et al. 2012], there wall_pressure is 0. With the symmetric wall term it is 0
// too, and B_i counts twice.
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"
#include "cpu/wall.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_acceleration(State<Real>& state, Range part) {
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
