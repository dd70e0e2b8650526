// Pseudo-mass of every boundary sample, from how densely the wall is sampled around it: of a single layer of
// samples each stands for more mass than one of several layers [Akinci et al. 2012; WCSPH page]:
//   Psi_b = rho0 / sum_l W_bl, over all boundary samples l, itself included
// Samples rest, so this is done once.
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pseudo_mass(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(state.sizes.boundary, state.threads, [&](size_t b) {
    const glm::vec<2, Real> x_b = state.x_boundary[b];
    Real sum{};
    for_each_row(state.C_boundary, params.columns, cell_of(params, x_b), [&](uint32_t first, uint32_t last) {
      for (uint32_t l = first; l < last; ++l) {
        const glm::vec<2, Real> x_bl = x_b - state.x_boundary[l];
        const Real r_squared = glm::dot(x_bl, x_bl);
        if (r_squared < params.support_squared) sum += kernel(params, std::sqrt(r_squared));
      }
    });
    state.Psi[b] = params.rho0 / sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pseudo_mass)
