// Pressure acceleration, symmetric in i and j; a boundary sample mirrors the pressure of the particle that
// looks at it, with rho0 [Hunkler 2022, algorithm 7]. With q = p/rho^2 and B_i = m sum_b dW_ib:
//   a_p = -m sum_j (q_i + q_j) dW_ij - (q_i + p_i/rho0^2) B_i
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void pressure_acceleration(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](uint32_t i) {
    const Real q_i = state.q[i];
    glm::vec<2, Real> sum{};
    for_each_neighbour(state, i, [&](uint32_t j, glm::vec<2, Real> dW) { sum += (q_i + state.q[j]) * dW; });
    sum = -(params.m * sum);
    if (walls) sum -= (q_i + state.p[i] * params.wall_pressure) * state.wall_gradient[i];
    state.a_p[i] = sum;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(pressure_acceleration)
