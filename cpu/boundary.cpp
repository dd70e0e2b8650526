// All that a particle needs of the boundary in this step, summed once: no later stage walks over boundary
// samples, which rest. m_b is the mass of a sample: m with a mirror boundary [Hunkler 2022, section 5.2],
// Psi_b with that of [Akinci et al. 2012].
//   wall_density = sum_b m_b W_ib        B_i = sum_b m_b dW_ib
//   wall_gradient_squares = sum_b |m dW_ib|^2, for the diagonal of the linear system with the thesis's wall
//   term
// With the symmetric wall term of the linear system B_i is twice that.
//   wall_viscosity = sum_b m_b dW_ib x_ib^T / (x_ib.x_ib + 0.01 H^2), which applied to v_i gives the viscous
//   term
#include "cpu/stages.hpp"
#include "cpu/wall_sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void boundary(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const auto set = wall_sums_setter(state, params);
  for_each_index(params.n, state.threads, [&](size_t i) { set(i, wall_sums_at(state, params, state.x[i])); });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(boundary)
