// IISPH: how far the pressure system is from being solved, as sums per chunk of particles, with r = s - Ap:
//   error           |r| of those whose q a step with t = omega does not take below zero [Hunkler 2022,
//   algorithm 6] counted         how many these are squares         r^2, but where q = 0 only of r < 0: a
//   positive r asks for less pressure than none source_squares  s^2 where s < 0: what `squares` is without
//   any pressure
// and with S and Y the last changes of q and of -r/A_ii, in the inner product weighted by -A_ii, in which the
// system is symmetric [Barzilai & Borwein 1988]:
//   SS = S'S    SY = S'Y    YY = Y'Y
// A particle with A_ii = 0 (nobody in reach) has no part in any.
#include <array>
#include <cmath>

#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void residual(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool barzilai_borwein = state.needs.barzilai_borwein;
  const uint64_t chunks = state.sizes.chunks();
  for_each_chunk(params.n, state.threads, [&](uint32_t chunk, uint32_t first, uint32_t last) {
    std::array<Real, residual_sum_count> sums{};
    const auto at = [&](ResidualSum sum) -> Real& { return sums[static_cast<uint32_t>(sum)]; };
    for (uint32_t i = first; i < last; ++i) {
      const Real A = state.A_ii[i], q = state.q[i], s = state.s[i], Ap = state.Ap[i];
      if (A == Real(0)) continue;
      const Real r = s - Ap;
      if (!(q + params.omega * r / A < Real(0))) {
        at(ResidualSum::error) += std::abs(r);
        at(ResidualSum::counted) += Real(1);
      }
      if (q > Real(0) || !(r > Real(0))) at(ResidualSum::squares) += r * r;
      if (s < Real(0)) at(ResidualSum::source_squares) += s * s;
      if (!barzilai_borwein) continue;
      const Real S = q - state.q_before[i], change = state.Ap_before[i] - Ap;  // -A_ii Y
      at(ResidualSum::SS) -= S * S * A;
      at(ResidualSum::SY) += S * change;
      at(ResidualSum::YY) -= change * change / A;
    }
    for (uint32_t sum = 0; sum < residual_sum_count; ++sum)
      state.residual_sums[sum * chunks + chunk] = sums[sum];
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(residual)
