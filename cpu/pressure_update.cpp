// IISPH: one step of the projected iteration on q = p/rho^2:
//   q := max(q + t (s - Ap)/A_ii, 0)
// With t = omega it is that of the relaxed Jacobi iteration [Hunkler 2022, algorithm 6], there written in p.
// The stage `stop_test` chooses t, and whether to start from the last q, from nothing, or to go back to the
// best q of this solve. A particle with A_ii = 0 (nobody in reach) keeps its q. Differs from [Hunkler 2022,
// algorithm 6]: line 14 there reads (Ap) != 0, with which pressure would never start.
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_update(State<Real>& state) {
  const bool keeps_last = state.params.solver != static_cast<uint32_t>(Solver::jacobi);
  const glm::vec<4, Real> solve = state.solve[0];
  const Real t = solve.z, start = solve.w;
  const bool is_best = solve.x == solve.y;
  for_each_group(state, [&](const auto& i) {
    const auto q = i(state.q), Ap = i(state.Ap), A = i(state.A_ii);
    if (is_best) i.set(state.q_best, q);
    if (keeps_last) {
      i.set(state.q_before, q);
      i.set(state.Ap_before, Ap);
    }
    if (start < Real(0)) {
      i.set(state.q, i(state.q_best));
    } else if (start == Real(0)) {
      i.set(state.q, broadcast(Real(0)));
    } else {
      const auto moved = positive_part(q + t * (i(state.s) - Ap) / A);
      i.set(state.q, A == Real(0) ? q : moved);
    }
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pressure_update)
