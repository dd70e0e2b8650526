// The operator of the pressure system, several particles side by side.
#include "cpu/simd/partwise.hpp"
#include "cpu/simd/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_operator(State<Real>& state, Part part) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto dW) { return std::array{dot(i(state.a_p) - j(state.a_p), dW)}; };
  const auto finish = [&](auto i, auto sums) {
    auto total = params.m * sums[0];
    if (walls) total += dot(i(state.a_p), i(state.wall_gradient));
    i.set(state.Ap, (params.dt * params.dt) * total);
  };
  const auto sum = [&](auto fetch) {
    sum_over_neighbours(state, part, std::array<Real, 1>{}, term, finish, fetch);
  };
  if (part.ahead > 0)
    sum(PrefetchFurther{part.ahead});
  else
    sum(NoPrefetch{});
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_PARTWISE_STAGE(pressure_operator)
