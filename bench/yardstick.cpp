// NEVER optimise this file: it is the fixed measure that speeds are compared with (see bench/yardstick.hpp).
#include "bench/yardstick.hpp"

#include <algorithm>
#include <cmath>

namespace sluice::bench {
namespace {

using Gradient = YardstickKernel::Gradient;

}  // namespace

Yardstick::Yardstick(const Backend& backend, const Params& params, const Samples& samples)
    : params_(params.to<float>()),
      fluid_(params.n),
      kernel_{static_cast<float>(1 / params.inverse_H)},
      grid_(params_, kernel_.H) {
  const auto x = by_id(backend, Field::x, fluid_, 2);
  const auto rho = by_id(backend, Field::rho, fluid_, 1), p = pressures_of(backend);
  const auto A_ii = by_id(backend, Field::A_ii, fluid_, 1), s = by_id(backend, Field::s, fluid_, 1);
  const auto real = [](double value) { return static_cast<float>(value); };
  for (size_t i = 0; i < fluid_; ++i) {
    particles_.push_back({real(x[2 * i]), real(x[2 * i + 1]), 0, 0, real(rho[i]), real(p[i]),
                          real(A_ii[i] / (rho[i] * rho[i])), real(s[i]), 0, false});
  }
  for (const Vec2 sample : samples.boundary) {
    const Vec2 b = sample - params.origin;
    particles_.push_back({real(b.x), real(b.y), 0, 0, params_.rho0, 0, 0, 0, 0, true});
  }
  grid_.build(particles_);
}

/// Calls f(j, dW_ij) for all neighbours.
template <class F>
void Yardstick::for_each_neighbour(const Particle& particle, F&& f) const {
  grid_.for_each_neighbour(particles_, particle, [&](const Particle& other, float x, float y, float r) {
    f(other, kernel_.dW(x, y, r));
  });
}

void Yardstick::pressure_acceleration(Particle& particle) const {
  float a_x = 0, a_y = 0;
  const float q_i = particle.p / (particle.rho * particle.rho);
  for_each_neighbour(particle, [&](const Particle& other, Gradient dW) {
    float q_j;
    if (other.is_boundary) {
      q_j = particle.p * params_.wall_pressure;
    } else {
      q_j = other.p / (other.rho * other.rho);
    }
    a_x -= params_.m * (q_i + q_j) * dW.x;
    a_y -= params_.m * (q_i + q_j) * dW.y;
  });
  particle.a_x = a_x;
  particle.a_y = a_y;
}

float Yardstick::change_of_density(const Particle& particle) const {
  float sum = 0;
  for_each_neighbour(particle, [&](const Particle& other, Gradient dW) {
    if (other.is_boundary) {
      sum += params_.m * (particle.a_x * dW.x + particle.a_y * dW.y);
    } else {
      sum += params_.m * ((particle.a_x - other.a_x) * dW.x + (particle.a_y - other.a_y) * dW.y);
    }
  });
  return params_.dt * params_.dt * sum;
}

float Yardstick::sweep() {
  for (Particle& particle : particles_) {
    if (!particle.is_boundary) pressure_acceleration(particle);
  }
  float error = 0;
  uint32_t counted = 0;
  for (Particle& particle : particles_) {
    if (particle.is_boundary || particle.A_ii == 0) continue;
    const float difference = particle.s - change_of_density(particle);
    const float p = particle.p + params_.omega * difference / particle.A_ii;
    particle.p = std::max(p, 0.0f);
    if (p >= 0) {
      error += std::abs(difference) / params_.rho0;
      counted++;
    }
  }
  return counted > 0 ? error / static_cast<float>(counted) : 0;
}

std::vector<double> Yardstick::pressures() const {
  std::vector<double> p;
  for (size_t i = 0; i < fluid_; ++i) p.push_back(static_cast<double>(particles_[i].p));
  return p;
}

/// The backend sweeps over q = p/rho^2, and computes p when it is done.
std::vector<double> Yardstick::pressures_of(const Backend& backend) const {
  const auto rho = by_id(backend, Field::rho, fluid_, 1), q = by_id(backend, Field::q, fluid_, 1);
  std::vector<double> p;
  for (size_t i = 0; i < fluid_; ++i) p.push_back(q[i] * (rho[i] * rho[i]));
  return p;
}

double Yardstick::difference(const Backend& backend) const {
  return largest_difference(pressures(), pressures_of(backend));
}

}  // namespace sluice::bench
