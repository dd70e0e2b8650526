// Gathers ids, positions and velocities in cell order, so that neighbours in space are neighbours in memory.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void reorder(State<Real>& state) {
  for_each_index(state.params.n, state.threads, [&](size_t i) {
    const uint32_t from = state.L[i];
    state.id[i] = state.id_in[from];
    state.x[i] = state.x_in[from];
    state.v[i] = state.v_in[from];
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(reorder)
