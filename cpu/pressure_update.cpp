// IISPH: one step of the projected iteration on q = p/rho^2:
//   q := max(q + t (s - Ap)/A_ii, 0)
// With t = omega it is that of the relaxed Jacobi iteration [Hunkler 2022, algorithm 6], there written in p.
// The stage `stop_test` chooses t, and whether to start from the last q, from nothing, or to go back to the
// best q of this solve. A particle with A_ii = 0 (nobody in reach) keeps its q. Differs from [Hunkler 2022,
// algorithm 6]: line 14 there reads (Ap) != 0, with which pressure would never start.
#include "core/larger.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void pressure_update(State<Real>& state) {
  const bool keeps_last = state.needs.barzilai_borwein;
  const glm::vec<4, Real> solve = state.solve[0];
  const Real t = solve.z, start = solve.w;
  const bool is_best = solve.x == solve.y;
  for_each_index(state.params.n, state.threads, [&](uint32_t i) {
    const Real q = state.q[i], Ap = state.Ap[i], A = state.A_ii[i];
    if (is_best) state.q_best[i] = q;
    if (keeps_last) {
      state.q_before[i] = q;
      state.Ap_before[i] = Ap;
    }
    if (start < Real(0))
      state.q[i] = state.q_best[i];
    else if (start == Real(0))
      state.q[i] = Real(0);
    else if (A != Real(0))
      state.q[i] = at_least(Real(0), q + t * (state.s[i] - Ap) / A);
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(pressure_update)
