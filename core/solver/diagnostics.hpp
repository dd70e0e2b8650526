// What one step reports: means, extremes and totals over the fluid.
#pragma once

#include <span>

#include "core/model/params.hpp"

namespace sluice {

/// Densities are those computed in the step; positions and velocities those at its end.
struct Diagnostics {
  double mean_density = 0;
  double mean_compression = 0;  ///< mean of max(rho/rho0 - 1, 0)
  double max_compression = 0;
  double kinetic_energy = 0;
  double potential_energy = 0;  ///< -sum m g.x
  glm::dvec2 centre_of_mass{};
  double max_speed = 0;
  double max_speed_change = 0;  ///< largest |v - v before|
  double cfl = 0;               ///< max_speed dt / h
  glm::dvec2 wall_force{};      ///< force of the fluid's pressure on the boundary
  uint32_t lost = 0;            ///< particles left of, right of or below the domain

  /// Whether no position, velocity or density is NaN or infinite.
  bool finite() const;
};

/// `totals` as written by the stage of that name.
Diagnostics make_diagnostics(std::span<const double> totals, const Params& params);

}  // namespace sluice
