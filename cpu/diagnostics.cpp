// What the series and the summary report, per chunk of particles: sums of density, compression, speed
// squared, position and force on the walls, the number of lost particles, and the largest compression, speed
// squared and change of velocity squared. Densities and pressures are those of the step, positions and
// velocities those at its end. The force on the walls is minus the boundary term of the pressure force.
#include "cpu/chunk_sums.hpp"
#include "cpu/stages.hpp"
#include "cpu/wall.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void diagnostics(State<Real>& state) {
  using enum Total;
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_chunk(params.n, state.threads, [&](size_t chunk, size_t first, size_t last) {
    ChunkSums<Real, Total> sums;
    for (size_t i = first; i < last; ++i) {
      const glm::vec<2, Real> x_i = state.x_in[i], v_i = state.v_in[i], change_i = v_i - state.v[i];
      const Real rho_i = state.rho[i];
      const Real above = at_least(Real(0), (rho_i - params.rho0) / params.rho0);
      const bool is_lost = x_i.x < Real(0) || x_i.x > params.extent.x || x_i.y < Real(0);
      sums[density] += rho_i;
      sums[compression] += above;
      sums[speed_squared] += glm::dot(v_i, v_i);
      sums[x] += x_i.x;
      sums[y] += x_i.y;
      if (walls) {
        const glm::vec<2, Real> force =
            (params.m * wall_pressure_term(params, state.q[i], rho_i)) * state.wall_gradient[i];
        sums[wall_force_x] += force.x;
        sums[wall_force_y] += force.y;
      }
      if (is_lost) sums[lost] += Real(1);
      sums[max_compression] = larger(sums[max_compression], above);
      sums[max_speed_squared] = larger(sums[max_speed_squared], glm::dot(v_i, v_i));
      sums[max_speed_change_squared] = larger(sums[max_speed_change_squared], glm::dot(change_i, change_i));
    }
    sums.write(state.diagnostic_sums, chunk, state.sizes.chunks());
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(diagnostics)
