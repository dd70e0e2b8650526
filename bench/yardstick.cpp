// NEVER optimise this file: it is the fixed measure that speeds are compared with (see bench/yardstick.hpp).
#include "bench/yardstick.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sluice::bench {
namespace {

/// A field of the fluid in id order; `components` values per particle.
std::vector<double> by_id(const Backend& backend, Field field, uint32_t fluid, uint32_t components) {
  std::vector<uint32_t> id(fluid);
  backend.download(Field::id, id);
  std::vector<double> values(size_t{fluid} * components), sorted(values.size());
  backend.download(field, values);
  for (size_t i = 0; i < fluid; ++i) {
    for (size_t k = 0; k < components; ++k) sorted[id[i] * components + k] = values[i * components + k];
  }
  return sorted;
}

}  // namespace

Yardstick::Yardstick(const Backend& backend, const Params& params, const Samples& samples)
    : params_(params.to<float>()), H_(static_cast<float>(1 / params.inverse_H)), fluid_(params.n) {
  const auto x = by_id(backend, Field::x, fluid_, 2);
  const auto rho = by_id(backend, Field::rho, fluid_, 1), p = by_id(backend, Field::p, fluid_, 1);
  const auto A_ii = by_id(backend, Field::A_ii, fluid_, 1), s = by_id(backend, Field::s, fluid_, 1);
  const auto real = [](double value) { return static_cast<float>(value); };
  for (size_t i = 0; i < fluid_; ++i) {
    particles_.push_back({real(x[2 * i]), real(x[2 * i + 1]), 0, 0, real(rho[i]), real(p[i]), real(A_ii[i]),
                          real(s[i]), 0, false});
  }
  for (const Vec2 b : samples.boundary) {
    particles_.push_back({real(b.x), real(b.y), 0, 0, params_.rho0, 0, 0, 0, 0, true});
  }
  build_grid();
}

void Yardstick::build_grid() {
  C_.assign(params_.columns * params_.rows + 1, 0);
  L_.resize(particles_.size());
  for (Particle& particle : particles_) {
    particle.cell = cell_of(params_, glm::vec2(particle.x, particle.y));
    C_[particle.cell]++;
  }
  for (size_t c = 1; c < C_.size(); c++) C_[c] += C_[c - 1];
  for (uint32_t i = 0; i < particles_.size(); i++) {
    C_[particles_[i].cell]--;
    L_[C_[particles_[i].cell]] = i;
  }
}

Yardstick::Gradient Yardstick::kernel_gradient(float x, float y, float r) const {
  const float alpha = 5 / (14 * std::numbers::pi_v<float> * H_ * H_);
  const float q = r / H_;
  float slope = 0;
  if (q < 1) {
    slope = -3 * (2 - q) * (2 - q) + 12 * (1 - q) * (1 - q);
  } else if (q < 2) {
    slope = -3 * (2 - q) * (2 - q);
  }
  if (r == 0) return {0, 0};
  return {alpha * slope * x / (r * H_), alpha * slope * y / (r * H_)};
}

/// Calls f(j, dW_ij) for all fluid and boundary neighbours, found in the 9 cells around the particle.
template <class F>
void Yardstick::for_each_neighbour(const Particle& particle, F&& f) const {
  for (int row = -1; row <= 1; row++) {
    for (int column = -1; column <= 1; column++) {
      const uint32_t cell = static_cast<uint32_t>(static_cast<int>(particle.cell) +
                                                  row * static_cast<int>(params_.columns) + column);
      for (uint32_t place = C_[cell]; place < C_[cell + 1]; place++) {
        const Particle& other = particles_[L_[place]];
        if (&other == &particle) continue;
        const float x = particle.x - other.x, y = particle.y - other.y;
        const float r = std::sqrt(x * x + y * y);
        if (r < 2 * H_) f(other, kernel_gradient(x, y, r));
      }
    }
  }
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

double Yardstick::difference(const Backend& backend) const {
  const std::vector<double> own = pressures(), expected = by_id(backend, Field::p, fluid_, 1);
  double largest = 0, difference = 0;
  for (size_t i = 0; i < fluid_; ++i) {
    largest = std::max(largest, expected[i]);
    const double here = std::abs(own[i] - expected[i]);
    if (!(here <= difference)) difference = here;  // so that NaN is not lost
  }
  return difference / largest;
}

}  // namespace sluice::bench
