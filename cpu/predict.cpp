// Velocity without pressure: v* = v + dt a_n [Hunkler 2022, algorithm 9].
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void predict(State<Real>& state) {
  for_each_index(state.params.n, state.threads,
                 [&](size_t i) { state.v_star[i] = state.v[i] + state.params.dt * state.a_n[i]; });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(predict)
