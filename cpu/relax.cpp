// Relaxation of the start: with dt = 1 the pressure acceleration of a solve for s = rho0 - rho is the move
// that corrects the density. x := x + a_p, each move at most 0.1 h long.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void relax(State<Real>& state) {
  const Real longest = state.params.largest_move;
  for_each_index(state.params.n, state.threads, [&](size_t i) {
    glm::vec<2, Real> move = state.a_p[i];
    const Real length = glm::length(move);
    if (length > longest) move *= longest / length;
    state.x_in[i] = state.x[i] + move;
    state.v_in[i] = state.v[i];
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(relax)
