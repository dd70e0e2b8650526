// IISPH: one step of the projected iteration on q = p/rho^2:
//   q := max(q + t (s - Ap)/A_ii, 0)
// With t = omega it is that of the relaxed Jacobi iteration [Hunkler 2022, algorithm 6], there written in p.
// The stage `stop_test` chooses t, and whether to start from the last q, from nothing, or to go back to the
// best q of this solve. A particle with A_ii = 0 (nobody in reach) keeps its q. Differs from [Hunkler 2022,
// algorithm 6]: line 14 there reads (Ap) != 0, with which pressure would never start.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_update(State<Real>& state) {
  const bool keeps_last = state.params.solver != static_cast<uint32_t>(Solver::jacobi);
  const glm::vec<4, Real> solve = state.solve[0];
  const Real t = solve.z, start = solve.w;
  const bool is_best = solve.x == solve.y;
  for_each_index(state.params.n, state.threads, [&](size_t i) {
    const Real q_i = state.q[i], Ap_i = state.Ap[i], A = state.A_ii[i];
    if (is_best) state.q_best[i] = q_i;
    if (keeps_last) {
      state.q_before[i] = q_i;
      state.Ap_before[i] = Ap_i;
    }
    const Real moved = A == Real(0) ? q_i : at_least(Real(0), q_i + t * (state.s[i] - Ap_i) / A);
    state.q[i] = start < Real(0) ? state.q_best[i] : start == Real(0) ? Real(0) : moved;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pressure_update)
