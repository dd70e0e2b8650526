// WCSPH: rho := max(rho, rho0). Where particles are missing, at a free surface, the sum over neighbours falls
// short of rho0, and pressure would pull [WCSPH page]. All later stages and all output use the clamped value.
#include "core/model/larger.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void clamp_density(State<Real>& state) {
  const Real rho0 = state.params.rho0;
  for_each_index(state.params.n, state.threads,
                 [&](size_t i) { state.rho[i] = at_least(rho0, state.rho[i]); });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(clamp_density)
