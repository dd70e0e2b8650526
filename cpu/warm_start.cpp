// IISPH: the pressure the solve starts from, a share of the last step's [Ihmsen et al. 2014]; 0 in the first
// step:
//   q = warm_start p_in/rho^2
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void warm_start(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const Real rho = state.rho[i];
    state.q[i] = params.warm_start * state.p_in[state.L[i]] / (rho * rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(warm_start)
