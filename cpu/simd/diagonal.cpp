// Diagonal of the pressure system, several particles side by side.
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

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
  sum_over_neighbours(state, std::array<Real, 3>{}, term, finish, NoPrefetch{});
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(diagonal)
