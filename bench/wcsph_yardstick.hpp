// The yardstick of whole WCSPH steps: one step as a straightforward programmer would write it from the WCSPH
// page, in the manner of bench/yardstick.hpp. It must NEVER be optimised. One thread, float; an array of
// structs that is never sorted, fluid and boundary in one; neighbours found anew in each of the three passes;
// kernels with branches; pow. tests/bench/test_yardstick.cpp checks it against the CPU backend.
#pragma once

#include <vector>

#include "bench/yardstick_parts.hpp"
#include "sluice/sampling.hpp"

namespace sluice::bench {

class WcsphYardstick {
 public:
  /// Starts from the positions and velocities that `backend` has reached, with an akinci boundary.
  WcsphYardstick(const Backend& backend, const Params& params, const Samples& samples);

  /// One step, its grid included.
  void step();

  /// Largest difference of the velocities from those of `backend`, relative to the largest of these.
  double difference(const Backend& backend) const;

 private:
  struct Particle {
    float x, y, vx, vy;
    float ax, ay;
    float rho, p;
    float mass;  ///< m, or the pseudo-mass of a boundary sample
    uint32_t cell;
    bool is_boundary;
  };

  void compute_pseudo_masses();
  void compute_density(Particle& particle) const;
  void compute_viscosity(Particle& particle) const;
  void compute_pressure_acceleration(Particle& particle) const;

  ParamsOf<float> params_;
  uint32_t fluid_;
  YardstickKernel kernel_;
  YardstickGrid<Particle> grid_;
  std::vector<Particle> particles_;
};

}  // namespace sluice::bench
