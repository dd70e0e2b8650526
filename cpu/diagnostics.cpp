// What the series and the summary report, per chunk of particles: sums of density, compression, speed
// squared, position and force on the walls, the number of lost particles, and the largest compression and
// speed squared. Densities and pressures are those of the step, positions and velocities those at its end.
// The force on the walls is minus the boundary term of the pressure force.
#include "cpu/fold.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void diagnostics(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  const uint64_t chunks = state.sizes.chunks();
  for_each_chunk(params.n, state.threads, [&](uint32_t chunk, uint32_t first, uint32_t last) {
    std::array<Real, total_count> sums{};
    const auto at = [&](Total total) -> Real& { return sums[static_cast<uint32_t>(total)]; };
    for (uint32_t i = first; i < last; ++i) {
      const glm::vec<2, Real> x = state.x_in[i], v = state.v_in[i];
      const Real compression = at_least(Real(0), (state.rho[i] - params.rho0) / params.rho0);
      const Real speed_squared = glm::dot(v, v);
      at(Total::density) += state.rho[i];
      at(Total::compression) += compression;
      at(Total::speed_squared) += speed_squared;
      at(Total::x) += x.x;
      at(Total::y) += x.y;
      if (walls) {
        const Real pressure = wall_pressure_term(params, state.q[i], state.rho[i]);
        const glm::vec<2, Real> force = (params.m * pressure) * state.wall_gradient[i];
        at(Total::wall_force_x) += force.x;
        at(Total::wall_force_y) += force.y;
      }
      if (is_lost(params, x)) at(Total::lost) += Real(1);
      at(Total::max_compression) = larger(at(Total::max_compression), compression);
      at(Total::max_speed_squared) = larger(at(Total::max_speed_squared), speed_squared);
    }
    for (uint32_t total = 0; total < total_count; ++total)
      state.diagnostic_sums[total * chunks + chunk] = sums[total];
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(diagnostics)
