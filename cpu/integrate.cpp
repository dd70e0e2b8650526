// Symplectic Euler: v = v* + dt a_p, x = x + dt v [Hunkler 2022, algorithm 9].
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void integrate(State<Real>& state) {
  const Real dt = state.params.dt;
  for_each_index(state.params.n, state.threads, [&](size_t i) {
    state.v_in[i] = state.v_star[i] + dt * state.a_p[i];
    state.x_in[i] = state.x[i] + dt * state.v_in[i];
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(integrate)
