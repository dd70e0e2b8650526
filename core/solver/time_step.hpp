// The time step: what bounds it, and how it follows the fluid from step to step.
#pragma once

#include "core/solver/diagnostics.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Bound on the time step: a duration of the scene, whatever the fluid's speed, and how many such durations a
/// step may take.
struct StepBound {
  double duration;  ///< infinite where the scene has no such bound
  double safe;      ///< adaptive steps are at most so many durations
  double largest;   ///< longer ones are warned of
};

/// Bounds on the time steps of a scene.
struct StepBounds {
  StepBound viscous;  ///< h^2/nu: an explicit viscosity overshoots
  StepBound sound;    ///< h/c, with c the speed of sound at rest density: a state equation overshoots
  StepBound depth;    ///< h/sqrt(g depth): the pressure of a step pushes deep fluid into the floor (IISPH)

  /// Longest step that keeps within all bounds.
  double safe() const;
};
/// Bound by the speed of sound alone.
StepBound sound_bound(const Scene& scene);
StepBounds step_bounds(const Scene& scene, const Samples& samples);

/// Acceleration by the external forces at x: the stage `external` on the host.
Vec2 external_acceleration(const Scene& scene, Vec2 x);

/// The speed of sound at rest density; infinite with IISPH.
double speed_of_sound(const Scene& scene);

/// The speed that fluid which starts at `samples` may have when it has fallen to the lowest boundary sample.
double largest_impact_speed(const Scene& scene, const Samples& samples);

/// Chooses the time steps of a scene with time.cfl.
class StepControl {
 public:
  StepControl(const AdaptiveStep& limits, double h, double safe) : limits_(limits), h_(h), safe_(safe) {}

  /// The longest step in which a particle with this speed and acceleration moves by at most cfl h, and which
  /// is safe otherwise; within dt_min and dt_max.
  double longest(double speed, double acceleration) const;
  /// The step after one of length `dt` that led to `d`: shorter at once, longer only by and by.
  double next(double dt, const Diagnostics& d) const;

  /// Whether a step moved nothing by more than cfl h.
  bool holds(const Diagnostics& d) const { return d.finite() && d.cfl <= limits_.cfl; }
  /// Length with which to repeat a step of length `dt` that did not hold; none when that would be below
  /// dt_min.
  std::optional<double> shorter(double dt, const Diagnostics& d) const;

  const AdaptiveStep& limits() const { return limits_; }

 private:
  AdaptiveStep limits_;
  double h_, safe_;
};

}  // namespace sluice
