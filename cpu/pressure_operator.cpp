// IISPH: change of density by the pressure accelerations, the operator applied to p [Hunkler 2022, eq. 5.19]:
//   (Ap)_i = dt^2 ( m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i )
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu {

template <class Real>
void pressure_operator(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  const auto term = [&](auto i, auto j, auto dW) { return std::array{dot(i(state.a_p) - j(state.a_p), dW)}; };
  sum_over_neighbours(state, std::array<Real, 1>{}, term, [&](uint32_t i, auto sums) {
    Real sum = params.m * sums[0];
    if (walls) sum += glm::dot(state.a_p[i], state.wall_gradient[i]);
    state.Ap[i] = (params.dt * params.dt) * sum;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(pressure_operator)
