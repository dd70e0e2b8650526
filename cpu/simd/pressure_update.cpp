// One step on q, several particles side by side.
#include "cpu/kernel.hpp"
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

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
