// IISPH: diagonal of the pressure system with respect to q = p/rho^2 [Hunkler 2022, eq. 5.13, which is that
// with respect to p and has a further 1/rho_i^2]:
//   A_ii = -dt^2 ( |m sum_j dW_ij + B_i|^2 + sum |m dW|^2 )
// With the wall term of the thesis the sum of squares is over fluid and mirror samples alike. Otherwise
// samples have no part in it: they do not answer to pressure with a pressure of their own [Ihmsen et al.
// 2014], and this is the exact diagonal of the operator. Differs from [Hunkler 2022, eq. 5.13]: printed there
// with separate inner sums for fluid and boundary; one sum over all neighbours, as in algorithm 6, is what
// gives the published iteration counts.
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void diagonal(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary, thesis_wall = state.needs.thesis_wall;
  const auto term = [](auto, auto, auto dW) { return std::array{dW.x, dW.y, dot(dW, dW)}; };
  const auto finish = [&](auto i, auto sums) {
    auto sum = params.m * Pair{sums[0], sums[1]};
    auto squares = params.m * params.m * sums[2];
    if (walls) sum += i(state.wall_gradient);
    if (thesis_wall) squares += i(state.wall_gradient_squares);
    i.set(state.A_ii, -(params.dt * params.dt) * (dot(sum, sum) + squares));
  };
  sum_over_neighbours(state, std::array<Real, 3>{}, term, finish, Nothing{});
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(diagonal)
