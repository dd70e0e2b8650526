// XSPH: velocities smoothed over the neighbours, as an acceleration, from the velocities at the start of the
// step and of the fluid only [WCSPH page]:
//   a_n -= (alpha m/dt) sum_j (1/rho_j) (v_i - v_j) W_ij
#include "cpu/kernel.hpp"
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void xsph(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const glm::vec<2, Real> x_i = state.x[i], v_i = state.v[i];
    glm::vec<2, Real> sum{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      const uint32_t j = state.index[entry];
      const Real weight = kernel(params, glm::length(x_i - state.x[j])) / state.rho[j];
      sum += weight * (v_i - state.v[j]);
    });
    state.a_n[i] = state.a_n[i] - params.xsph * sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(xsph)
