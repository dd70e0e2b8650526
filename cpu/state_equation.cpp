// SSPH: pressure from a state equation, p = max(k (rho/rho0 - 1), 0) [Hunkler 2022, eq. 5.5], and q =
// p/rho^2.
#include "core/larger.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void state_equation(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](uint32_t i) {
    const Real rho = state.rho[i];
    state.p[i] = larger(Real(0), params.k * (rho / params.rho0 - Real(1)));
    state.q[i] = state.p[i] / (rho * rho);
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(state_equation)
