// SSPH: pressure from a state equation [Hunkler 2022, eq. 5.5], written so that no digits cancel:
//   p = max(k (rho - rho0)/rho0, 0),   q = p/rho^2
#include "core/model/larger.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void state_equation(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const Real rho = state.rho[i];
    state.p[i] = at_least(Real(0), params.k * ((rho - params.rho0) / params.rho0));
    state.q[i] = state.p[i] / (rho * rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(state_equation)
