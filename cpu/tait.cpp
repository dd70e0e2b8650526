// WCSPH: pressure from Tait's equation, of the clamped density, so that it is never negative [Becker &
// Teschner 2007; WCSPH page]:
//   p = kappa rho0/gamma ((rho/rho0)^gamma - 1),   q = p/rho^2
//
// The power is not left to pow(), which differs from machine to machine, and after which "- 1" would cancel
// most of its digits. With e = rho/rho0 - 1 every power is kept as u = (1 + e)^a - 1, and made of operations
// that all machines round alike:
//   a -> 2a:      u (2 + u)
//   a -> a/2:     u / (1 + sqrt(1 + u))
//   a, b -> a+b:  u_a + u_b + u_a u_b
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// (1 + e)^gamma - 1 for gamma >= 1, by the binary digits of gamma, from the first one on.
template <class Real>
Real power_less_one(Real e, Real gamma) {
  const auto whole = static_cast<uint32_t>(gamma);
  Real power = e;
  for (uint32_t digit = std::bit_floor(whole) / 2; digit > 0; digit /= 2) {
    power *= Real(2) + power;
    if ((whole & digit) != 0) power += e + power * e;
  }
  Real u = e;
  for (Real digits = gamma - static_cast<Real>(whole); digits > Real(0);) {
    u /= Real(1) + std::sqrt(Real(1) + u);
    digits *= Real(2);
    if (digits < Real(1)) continue;
    power += u + power * u;
    digits -= Real(1);
  }
  return power;
}

}  // namespace

template <class Real>
void tait(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const Real rho = state.rho[i];
    state.p[i] = params.tait_factor * power_less_one((rho - params.rho0) / params.rho0, params.gamma);
    state.q[i] = state.p[i] / (rho * rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(tait)
