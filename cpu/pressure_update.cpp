// IISPH: one relaxed Jacobi step, p := max(p + omega (s - Ap)/A_ii, 0), and q = p/rho^2 [Hunkler 2022,
// algorithm 6]. Per chunk of particles also the residual |Ap - s|/rho0, summed over those whose updated
// pressure did not fall below zero, and how many these are. A particle with A_ii = 0 (nobody in reach) keeps
// its pressure and is not counted. Differs from [Hunkler 2022, algorithm 6]: line 14 there reads (Ap) != 0,
// with which pressure would never start.
#include <cmath>

#include "core/larger.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void pressure_update(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const uint64_t chunks = state.sizes.chunks();
  for_each_chunk(params.n, state.threads, [&](uint32_t chunk, uint32_t first, uint32_t last) {
    Real error{}, counted{};
    for (uint32_t i = first; i < last; ++i) {
      if (state.A_ii[i] == Real(0)) continue;
      const Real difference = state.s[i] - state.Ap[i];
      const Real p = state.p[i] + params.omega * difference / state.A_ii[i];
      const Real rho = state.rho[i];
      state.p[i] = at_least(Real(0), p);
      state.q[i] = state.p[i] / (rho * rho);
      if (p < Real(0)) continue;
      error += std::abs(difference) / params.rho0;
      counted += Real(1);
    }
    state.residual_sums[chunk] = error;
    state.residual_sums[chunks + chunk] = counted;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(pressure_update)
