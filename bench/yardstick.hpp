// The yardstick: one pressure sweep of IISPH as a straightforward programmer would write it. Later speeds are
// given as multiples of it, so it must NEVER be optimised, nor follow changes of the solver's data layout.
// What it is: one thread, float; an array of structs in id order, never sorted; fluid and boundary in the
// same array, told apart by a flag; neighbours found anew in every pass by walking over the 9 cells around a
// particle through the arrays C and L [Hunkler 2022, algorithms 3 and 4]; a kernel gradient with branches,
// recomputed for every pair. tests/bench/test_yardstick.cpp checks it against the CPU backend.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/yardstick_parts.hpp"
#include "sluice/sampling.hpp"

namespace sluice::bench {

class Yardstick {
 public:
  /// Takes the pressure system that `backend` holds after a step, or in one once its source is computed.
  /// Builds C and L: like the solver's search, this is not part of a sweep.
  Yardstick(const Backend& backend, const Params& params, const Samples& samples);

  /// One sweep: pressure acceleration, operator and update. Returns the mean error |Ap - s|/rho0.
  float sweep();

  /// Pressure of the fluid in id order.
  std::vector<double> pressures() const;

  /// Largest difference of the pressures from those of `backend`, relative to the largest of these.
  double difference(const Backend& backend) const;

 private:
  struct Particle {
    float x, y;
    float a_x, a_y;  ///< pressure acceleration
    float rho, p, A_ii, s;
    uint32_t cell;
    bool is_boundary;
  };
  template <class F>
  void for_each_neighbour(const Particle& particle, F&& f) const;
  std::vector<double> pressures_of(const Backend& backend) const;
  void pressure_acceleration(Particle& particle) const;
  float change_of_density(const Particle& particle) const;

  ParamsOf<float> params_;
  uint32_t fluid_;
  YardstickKernel kernel_;
  YardstickGrid<Particle> grid_;
  std::vector<Particle> particles_;
};

}  // namespace sluice::bench
