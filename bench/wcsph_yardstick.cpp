// NEVER optimise this file: it is the fixed measure that speeds are compared with (see
// bench/wcsph_yardstick.hpp).
#include "bench/wcsph_yardstick.hpp"

#include <algorithm>
#include <cmath>

namespace sluice::bench {

WcsphYardstick::WcsphYardstick(const Backend& backend, const Params& params, const Samples& samples)
    : params_(params.to<float>()),
      fluid_(params.n),
      kernel_{static_cast<float>(1 / params.inverse_H)},
      grid_(params_, kernel_.H) {
  const auto x = by_id(backend, Field::x_in, fluid_, 2), v = by_id(backend, Field::v_in, fluid_, 2);
  const auto real = [](double value) { return static_cast<float>(value); };
  for (const Vec2 sample : samples.boundary) {
    const Vec2 b = sample - params.origin;
    particles_.push_back({real(b.x), real(b.y), 0, 0, 0, 0, 0, 0, 0, 0, true});
  }
  compute_pseudo_masses();
  for (size_t i = 0; i < fluid_; ++i) {
    particles_.push_back({real(x[2 * i]), real(x[2 * i + 1]), real(v[2 * i]), real(v[2 * i + 1]), 0, 0, 0, 0,
                          params_.m, 0, false});
  }
}

/// While there is no fluid yet.
void WcsphYardstick::compute_pseudo_masses() {
  grid_.build(particles_);
  for (Particle& particle : particles_) {
    float sum = kernel_.W(0);
    grid_.for_each_neighbour(particles_, particle,
                             [&](const Particle&, float, float, float r) { sum += kernel_.W(r); });
    particle.mass = params_.rho0 / sum;
  }
}

void WcsphYardstick::compute_density(Particle& particle) const {
  float rho = params_.m * kernel_.W(0);
  grid_.for_each_neighbour(particles_, particle, [&](const Particle& other, float, float, float r) {
    rho += other.mass * kernel_.W(r);
  });
  particle.rho = std::max(rho, params_.rho0);
  particle.p = params_.tait_factor * (std::pow(particle.rho / params_.rho0, params_.gamma) - 1);
}

void WcsphYardstick::compute_viscosity(Particle& particle) const {
  grid_.for_each_neighbour(particles_, particle, [&](const Particle& other, float, float, float r) {
    if (other.is_boundary) return;
    const float weight = params_.xsph / other.rho * kernel_.W(r);
    particle.ax -= weight * (particle.vx - other.vx);
    particle.ay -= weight * (particle.vy - other.vy);
  });
}

void WcsphYardstick::compute_pressure_acceleration(Particle& particle) const {
  const float q_i = particle.p / (particle.rho * particle.rho);
  grid_.for_each_neighbour(particles_, particle, [&](const Particle& other, float x, float y, float r) {
    const auto dW = kernel_.dW(x, y, r);
    float q = q_i;
    if (!other.is_boundary) q += other.p / (other.rho * other.rho);
    particle.ax -= other.mass * q * dW.x;
    particle.ay -= other.mass * q * dW.y;
  });
}

void WcsphYardstick::step() {
  grid_.build(particles_);
  for (Particle& particle : particles_) {
    if (!particle.is_boundary) compute_density(particle);
  }
  for (Particle& particle : particles_) {
    if (particle.is_boundary) continue;
    particle.ax = params_.gravity.x;
    particle.ay = params_.gravity.y;
    compute_viscosity(particle);
    compute_pressure_acceleration(particle);
  }
  for (Particle& particle : particles_) {
    if (particle.is_boundary) continue;
    particle.vx += params_.dt * particle.ax;
    particle.vy += params_.dt * particle.ay;
    particle.x += params_.dt * particle.vx;
    particle.y += params_.dt * particle.vy;
  }
}

double WcsphYardstick::difference(const Backend& backend) const {
  std::vector<double> v;
  for (const Particle& particle : particles_) {
    if (particle.is_boundary) continue;
    v.push_back(static_cast<double>(particle.vx));
    v.push_back(static_cast<double>(particle.vy));
  }
  return largest_difference(v, by_id(backend, Field::v_in, fluid_, 2));
}

}  // namespace sluice::bench
