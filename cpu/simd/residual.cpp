// Sums of the residual per chunk: what each particle has a share in is computed side by side, and added up
// one by one.
#include "cpu/simd/chunk_sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

template <class Real>
void shares_in_error(const State<Real>& state, const auto& i, size_t place, auto& shares) {
  const auto A = i(state.A_ii), q = i(state.q), s = i(state.s), Ap = i(state.Ap);
  const Vector<Real> zero{};
  const auto counts = A != zero;
  const auto r = s - Ap;
  const auto stays = counts & ~(q + state.params.omega * r / A < zero);
  shares.set(ResidualSum::error, place, select(stays, r < zero ? -r : r, zero));
  shares.set(ResidualSum::counted, place, select(stays, broadcast(Real(1)), zero));
  shares.set(ResidualSum::squares, place, select(counts & ((q > zero) | ~(r > zero)), r * r, zero));
  shares.set(ResidualSum::source_squares, place, select(counts & (s < zero), s * s, zero));
}

template <class Real>
void shares_in_step(const State<Real>& state, const auto& i, size_t place, auto& shares) {
  const auto A = i(state.A_ii);
  const Vector<Real> zero{};
  const auto counts = A != zero;
  const auto S = i(state.q) - i(state.q_before), change = i(state.Ap_before) - i(state.Ap);  // -A_ii Y
  shares.set(ResidualSum::SS, place, select(counts, -(S * S * A), zero));
  shares.set(ResidualSum::SY, place, select(counts, S * change, zero));
  shares.set(ResidualSum::YY, place, select(counts, -(change * change / A), zero));
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
    for (uint64_t at = count * state.sizes.chunks(); at < state.residual_sums.size(); ++at)
      state.residual_sums[at] = Real(0);
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
