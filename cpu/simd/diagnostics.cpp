// The sums of the diagnostics per chunk: what each particle has a share in is computed side by side, and
// added up one by one.
#include "cpu/kernel.hpp"
#include "cpu/simd/chunk_sums.hpp"
#include "cpu/stages.hpp"
#include "cpu/wall.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

template <class Real>
void shares_of(const State<Real>& state, const auto& i, size_t place, auto& shares) {
  const ParamsOf<Real>& params = state.params;
  const auto x = i(state.x_in), v = i(state.v_in);
  const auto change = v - i(state.v);
  const auto rho = i(state.rho);
  const auto compression = positive_part((rho - params.rho0) / params.rho0);
  const auto speed_squared = dot(v, v);
  shares.set(Total::density, place, rho);
  shares.set(Total::compression, place, compression);
  shares.set(Total::speed_squared, place, speed_squared);
  shares.set(Total::x, place, x.x);
  shares.set(Total::y, place, x.y);
  if (state.needs.boundary) {
    const auto pressure = wall_pressure_term(params, i(state.q), rho);
    const auto force = (params.m * pressure) * i(state.wall_gradient);
    shares.set(Total::wall_force_x, place, force.x);
    shares.set(Total::wall_force_y, place, force.y);
  }
  const auto is_lost = (x.x < Real(0)) | (x.x > params.extent.x) | (x.y < Real(0));
  shares.set(Total::lost, place, select(is_lost, broadcast(Real(1)), Vector<Real>{}));
  shares.set(Total::max_compression, place, compression);
  shares.set(Total::max_speed_squared, place, speed_squared);
  shares.set(Total::max_speed_change_squared, place, dot(change, change));
}

}  // namespace

template <class Real>
void diagnostics(State<Real>& state) {
  sum_over_chunks<total_count>(
      state, state.diagnostic_sums,
      [&](const auto& i, size_t place, auto& shares) { shares_of(state, i, place, shares); },
      [](uint32_t total, Real sum, Real share) {
        return total < first_max_total ? sum + share : larger(sum, share);
      });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(diagnostics)
