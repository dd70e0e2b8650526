// NEVER optimise this file: what both yardsticks are made of. The grid of the arrays C and L [Hunkler 2022,
// algorithms 3 and 4] over an array of structs that is never sorted, a walk over the 9 cells around a
// particle, and the kernel with branches.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/model/params.hpp"
#include "core/solver/backend.hpp"

namespace sluice::bench {

/// A field of the fluid in id order; `components` values per particle.
inline std::vector<double> by_id(const Backend& backend, Field field, uint32_t fluid, uint32_t components) {
  std::vector<uint32_t> id(fluid);
  backend.download(Field::id, id);
  std::vector<double> values(size_t{fluid} * components), sorted(values.size());
  backend.download(field, values);
  for (size_t i = 0; i < fluid; ++i) {
    for (size_t k = 0; k < components; ++k) sorted[id[i] * components + k] = values[i * components + k];
  }
  return sorted;
}

/// Largest difference between two equally long lists, relative to the largest value of the second.
inline double largest_difference(const std::vector<double>& own, const std::vector<double>& expected) {
  double largest = 0, difference = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(expected[i]));
    const double here = std::abs(own[i] - expected[i]);
    if (!(here <= difference)) difference = here;  // so that NaN is not lost
  }
  return difference / largest;
}

struct YardstickKernel {
  float H;

  float W(float r) const {
    const float alpha = 5 / (14 * std::numbers::pi_v<float> * H * H);
    const float q = r / H;
    if (q < 1) return alpha * ((2 - q) * (2 - q) * (2 - q) - 4 * (1 - q) * (1 - q) * (1 - q));
    if (q < 2) return alpha * (2 - q) * (2 - q) * (2 - q);
    return 0;
  }

  struct Gradient {
    float x, y;
  };
  Gradient dW(float x, float y, float r) const {
    const float alpha = 5 / (14 * std::numbers::pi_v<float> * H * H);
    const float q = r / H;
    float slope = 0;
    if (q < 1) {
      slope = -3 * (2 - q) * (2 - q) + 12 * (1 - q) * (1 - q);
    } else if (q < 2) {
      slope = -3 * (2 - q) * (2 - q);
    }
    if (r == 0) return {0, 0};
    return {alpha * slope * x / (r * H), alpha * slope * y / (r * H)};
  }
};

/// Particles are structs with x, y and cell.
template <class Particle>
class YardstickGrid {
 public:
  YardstickGrid(const ParamsOf<float>& params, float H) : params_(params), H_(H) {}

  void build(std::vector<Particle>& particles) {
    C_.assign(params_.columns * params_.rows + 1, 0);
    L_.resize(particles.size());
    for (Particle& particle : particles) {
      particle.cell = cell_of(params_, glm::vec2(particle.x, particle.y));
      C_[particle.cell]++;
    }
    for (size_t c = 1; c < C_.size(); c++) C_[c] += C_[c - 1];
    for (uint32_t i = 0; i < particles.size(); i++) {
      C_[particles[i].cell]--;
      L_[C_[particles[i].cell]] = i;
    }
  }

  /// Calls f(j, x_ij, y_ij, r) for all fluid and boundary neighbours, found in the 9 cells around the
  /// particle.
  template <class F>
  void for_each_neighbour(const std::vector<Particle>& particles, const Particle& particle, F&& f) const {
    for (int row = -1; row <= 1; row++) {
      for (int column = -1; column <= 1; column++) {
        const uint32_t cell = static_cast<uint32_t>(static_cast<int>(particle.cell) +
                                                    row * static_cast<int>(params_.columns) + column);
        for (uint32_t place = C_[cell]; place < C_[cell + 1]; place++) {
          const Particle& other = particles[L_[place]];
          if (&other == &particle) continue;
          const float x = particle.x - other.x, y = particle.y - other.y;
          const float r = std::sqrt(x * x + y * y);
          if (r < 2 * H_) f(other, x, y, r);
        }
      }
    }
  }

 private:
  ParamsOf<float> params_;
  float H_;
  std::vector<uint32_t> C_, L_;
};

}  // namespace sluice::bench
