// Totals of a step -> means and energies.
#include "core/solver/diagnostics.hpp"

#include <cmath>

#include "core/model/fields.hpp"

namespace sluice {

bool Diagnostics::finite() const {
  return std::isfinite(kinetic_energy) && std::isfinite(centre_of_mass.x) &&
         std::isfinite(centre_of_mass.y) && std::isfinite(mean_density);
}

Diagnostics make_diagnostics(std::span<const double> totals, const Params& params) {
  const auto at = [&](Total total) { return totals[static_cast<uint32_t>(total)]; };
  const double n = params.n;
  Diagnostics d;
  d.mean_density = at(Total::density) / n;
  d.mean_compression = at(Total::compression) / n;
  d.max_compression = at(Total::max_compression);
  d.kinetic_energy = 0.5 * params.m * at(Total::speed_squared);
  d.centre_of_mass = params.origin + glm::dvec2(at(Total::x), at(Total::y)) / n;
  d.potential_energy = -params.m * n * glm::dot(params.gravity, d.centre_of_mass);
  d.max_speed = std::sqrt(at(Total::max_speed_squared));
  d.max_speed_change = std::sqrt(at(Total::max_speed_change_squared));
  d.cfl = d.max_speed * params.dt / params.h;
  d.wall_force = {at(Total::wall_force_x), at(Total::wall_force_y)};
  d.lost = static_cast<uint32_t>(at(Total::lost));
  return d;
}

}  // namespace sluice
