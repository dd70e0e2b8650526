// IISPH: how far the pressure system is from being solved, as sums per chunk of particles. With r = s - Ap:
//
// - error, |r| of those whose q a step with t = omega does not take below zero [Hunkler 2022, algorithm 6];
// - counted, how many these are;
// - squares, r^2, but where q = 0 only of r < 0: a positive r asks for less pressure than none;
// - source_squares, s^2 where s < 0: what `squares` is without any pressure;
// - SS = S'S, SY = S'Y, YY = Y'Y of a Barzilai-Borwein step, with S and Y the last changes of q and of
// -r/A_ii,
//   in the inner product weighted by -A_ii, in which the system is symmetric [Barzilai & Borwein 1988].
//
// A particle with A_ii = 0 (nobody in reach) has no part in any.
#include "cpu/chunk_sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void residual(State<Real>& state) {
  using enum ResidualSum;
  const Real omega = state.params.omega;
  const bool jacobi = state.params.solver == static_cast<uint32_t>(Solver::jacobi);
  for_each_chunk(state.params.n, state.threads, [&](size_t chunk, size_t first, size_t last) {
    ChunkSums<Real, ResidualSum> sums;
    for (size_t i = first; i < last; ++i) {
      const Real A = state.A_ii[i], q_i = state.q[i], s_i = state.s[i], Ap_i = state.Ap[i];
      if (A == Real(0)) continue;
      const Real r = s_i - Ap_i;
      const bool stays = !(q_i + omega * r / A < Real(0));
      if (stays) sums[error] += std::abs(r);
      if (stays) sums[counted] += Real(1);
      if (q_i > Real(0) || !(r > Real(0))) sums[squares] += r * r;
      if (s_i < Real(0)) sums[source_squares] += s_i * s_i;
      if (jacobi) continue;
      const Real S = q_i - state.q_before[i], change = state.Ap_before[i] - Ap_i;  // -A_ii Y
      sums[SS] -= S * S * A;
      sums[SY] += S * change;
      sums[YY] -= change * change / A;
    }
    sums.write(state.residual_sums, chunk, state.sizes.chunks());
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(residual)
