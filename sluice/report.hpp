// What a step reports, what the fluid is like after it, and why a run ended early.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sluice/scene.hpp"

namespace sluice {

/// Means, extremes and totals over the fluid. Densities are those computed in the step; positions and
/// velocities those at its end.
struct Diagnostics {
  double mean_density = 0;
  double mean_compression = 0;  ///< mean of max(rho/rho0 - 1, 0)
  double max_compression = 0;
  double kinetic_energy = 0;
  double potential_energy = 0;  ///< -sum m g.x
  Vec2 centre_of_mass{};
  double max_speed = 0;
  double max_speed_change = 0;  ///< largest |v - v before|
  double cfl = 0;               ///< max_speed dt / h
  Vec2 wall_force{};            ///< force of the fluid's pressure on the boundary
  uint32_t lost = 0;            ///< particles left of, right of or below the domain

  /// Whether no position, velocity or density is NaN or infinite.
  bool finite() const;
};

/// What a sweep of the pressure solve found, before it changed the pressure.
struct SweepReport {
  double mean_compression = 0;  ///< mean of |Ap - s| / rho0 over those whose pressure is free, 0 without any
  double residual = 0;          ///< of the system, in parts of that without any pressure
  double step_length = 0;       ///< of the change of the pressure that follows, in parts of a Jacobi step
};

struct StepReport {
  uint64_t step = 0;  ///< 1 for the first
  double time = 0;    ///< at the end of the step
  double dt = 0;
  uint32_t repeats = 0;     ///< times an adaptive step was done again with a shorter dt
  uint32_t iterations = 0;  ///< 0 where pressure comes from a state equation
  double residual = 0;      ///< the last e
  bool converged = true;
  Diagnostics diagnostics;
  std::vector<SweepReport> sweeps;  ///< of the solve that stands, if they were asked for
};

/// What the fluid is like at a point between its particles; all 0 where none is in reach.
struct PointValues {
  double pressure = 0, density = 0;
  Vec2 velocity{};
};

/// What the fluid's pressure does to a boundary shape.
struct WallForce {
  Vec2 force{};
  double torque = 0;  ///< about the origin of the scene's coordinates, counterclockwise
};

/// Reason why a run is invalid, with the place and the moment.
struct Failure {
  uint64_t step = 0;
  double time = 0;
  uint32_t id = 0;
  Vec2 x{};  ///< last finite position of that particle
  std::string reason;
  bool collapsed = false;  ///< an adaptive step had to be shorter than it may be
};

/// State of the fluid, particles in the order of their ids.
struct Snapshot {
  std::vector<Vec2> x, v;
  std::vector<double> density, pressure;  ///< computed during the step that led to this state
  uint64_t step = 0;                      ///< the step that led to this state; 0 at the start
};

}  // namespace sluice
