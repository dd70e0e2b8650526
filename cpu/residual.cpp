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
namespace {

template <class Real>
void shares_in_error(const State<Real>& state, const auto& i, size_t place, auto& shares) {
  const auto A = i(state.A_ii), q = i(state.q), s = i(state.s), Ap = i(state.Ap);
  const auto zero = broadcast(Real(0));
  const auto counts = A != zero;
  const auto r = s - Ap;
  const auto stays = counts & ~(q + state.params.omega * r / A < zero);
  shares.set(ResidualSum::error, place, those(stays, r < zero ? -r : r));
  shares.set(ResidualSum::counted, place, those(stays, broadcast(Real(1))));
  shares.set(ResidualSum::squares, place, those(counts & ((q > zero) | ~(r > zero)), r * r));
  shares.set(ResidualSum::source_squares, place, those(counts & (s < zero), s * s));
}

template <class Real>
void shares_in_step(const State<Real>& state, const auto& i, size_t place, auto& shares) {
  const auto A = i(state.A_ii);
  const auto counts = A != broadcast(Real(0));
  const auto S = i(state.q) - i(state.q_before), change = i(state.Ap_before) - i(state.Ap);  // -A_ii Y
  shares.set(ResidualSum::SS, place, those(counts, -(S * S * A)));
  shares.set(ResidualSum::SY, place, those(counts, S * change));
  shares.set(ResidualSum::YY, place, those(counts, -(change * change / A)));
}

}  // namespace

template <class Real>
void residual(State<Real>& state) {
  const auto add = [](uint32_t, Real sum, Real share) { return sum + share; };
  if (state.params.solver == static_cast<uint32_t>(Solver::jacobi)) {
    constexpr auto count = static_cast<uint32_t>(ResidualSum::SS);
    sum_over_chunks<count>(
        state, state.residual_sums,
        [&](const auto& i, size_t place, auto& shares) { shares_in_error(state, i, place, shares); }, add);
    return;
  }
  sum_over_chunks<residual_sum_count>(
      state, state.residual_sums,
      [&](const auto& i, size_t place, auto& shares) {
        shares_in_error(state, i, place, shares);
        shares_in_step(state, i, place, shares);
      },
      add);
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(residual)
