// IISPH: the pressure that the solve of the system in q = p/rho^2 has found:
//   p = q rho^2
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure(State<Real>& state) {
  for_each_index(state.params.n, state.threads, [&](size_t i) {
    const Real rho = state.rho[i];
    state.p[i] = state.q[i] * (rho * rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pressure)
