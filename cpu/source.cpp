// IISPH: source of the pressure system [Hunkler 2022, eq. 5.17; Ihmsen et al. 2014]:
//   s_i = w (rho0 - rho_i) - dt ( m sum_j (v*_i - v*_j).dW_ij + v*_i.B_i )
// with source weight w, 1 in the thesis.
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void source(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const glm::vec<2, Real> v_i = state.v_star[i];
    Real sum{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      sum += glm::dot(v_i - state.v_star[state.index[entry]], gradient_of(state, entry));
    });
    sum = params.m * sum;
    if (walls) sum += glm::dot(v_i, state.wall_gradient[i]);
    state.s[i] = params.source_weight * (params.rho0 - state.rho[i]) - params.dt * sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(source)
