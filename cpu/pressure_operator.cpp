// IISPH: change of density by the pressure accelerations, the operator applied to p [Hunkler 2022, eq. 5.19]:
//   (Ap)_i = dt^2 ( m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i )
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_operator(State<Real>& state, Range part) {
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
    sum(Further{part.ahead});
  else
    sum(Nothing{});
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_PARTWISE_STAGE(pressure_operator)
