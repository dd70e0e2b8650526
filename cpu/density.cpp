// Density by summation over the neighbours, the particle itself and the boundary [Hunkler 2022, algorithm 5]:
//   rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void density(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](uint32_t i) {
    Real sum = kernel(params, Real(0));
    for_each_neighbour(state, i, [&](uint32_t j, glm::vec<2, Real>) {
      sum += kernel(params, glm::length(state.x[i] - state.x[j]));
    });
    state.rho[i] = params.m * sum + (walls ? state.wall_density[i] : Real(0));
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(density)
