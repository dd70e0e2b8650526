// XSPH: velocities smoothed over the neighbours, as an acceleration, from the velocities at the start of the
// step and of the fluid only [WCSPH page]:
//   a_n -= (alpha m/dt) sum_j (1/rho_j) (v_i - v_j) W_ij
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void xsph(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](uint32_t i) {
    const glm::vec<2, Real> x_i = state.x[i], v_i = state.v[i];
    glm::vec<2, Real> sum{};
    for_each_neighbour(state, i, [&](uint32_t j, glm::vec<2, Real>) {
      const Real W = kernel(params, glm::length(x_i - state.x[j]));
      sum += (W / state.rho[j]) * (v_i - state.v[j]);
    });
    state.a_n[i] -= params.xsph * sum;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(xsph)
