// Tait's equation, several particles side by side; compilers do not do that by themselves with loops in it.
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// (1 + e)^gamma - 1 for gamma >= 1, by the binary digits of gamma, from the first one on.
template <class Real, class Value>
Value power_less_one(Value e, Real gamma) {
  const auto whole = static_cast<uint32_t>(gamma);
  Value power = e;
  for (uint32_t digit = std::bit_floor(whole) / 2; digit > 0; digit /= 2) {
    power *= Real(2) + power;
    if ((whole & digit) != 0) power += e + power * e;
  }
  Value u = e;
  for (Real digits = gamma - static_cast<Real>(whole); digits > Real(0);) {
    u /= Real(1) + square_root(Real(1) + u);
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
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  for_each_group(state, [&](const auto& i) {
    const auto rho = i(state.rho);
    const auto p = params.tait_factor * power_less_one((rho - params.rho0) / params.rho0, params.gamma);
    i.set(state.p, p);
    i.set(state.q, p / (rho * rho));
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(tait)
