// Laplacian viscosity [Hunkler 2022, algorithm 8]:
//   a_n += 2 nu ( m sum_j (1/rho_j) (v_ij.x_ij)/(x_ij.x_ij + 0.01 H^2) dW_ij
//               + (1/rho_i) sum_b m_b (v_i.x_ib)/(x_ib.x_ib + 0.01 H^2) dW_ib )
// The sum over b stands in wall_viscosity. Not antisymmetric in i and j because of 1/rho_j, so it does not
// conserve momentum exactly.
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void viscosity(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const glm::vec<2, Real> x_i = state.x[i], v_i = state.v[i];
    glm::vec<2, Real> sum{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      const uint32_t j = state.index[entry];
      const glm::vec<2, Real> x_ij = x_i - state.x[j];
      const Real approach = glm::dot(v_i - state.v[j], x_ij);
      const Real weight = approach / ((glm::dot(x_ij, x_ij) + params.viscosity_floor) * state.rho[j]);
      sum += weight * gradient_of(state, entry);
    });
    sum = params.m * sum;
    if (walls) {
      const glm::vec<4, Real> t = state.wall_viscosity[i];
      sum += glm::vec<2, Real>(t.x * v_i.x + t.y * v_i.y, t.z * v_i.x + t.w * v_i.y) / state.rho[i];
    }
    state.a_n[i] = state.a_n[i] + (Real(2) * params.nu) * sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(viscosity)
