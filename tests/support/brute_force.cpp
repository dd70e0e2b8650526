// [Hunkler 2022], algorithms 5 to 9, for the mirror boundary, Laplacian viscosity, SSPH and IISPH.
#include "tests/support/brute_force.hpp"

#include <cmath>
#include <numbers>

namespace sluice::test {

BruteForce::BruteForce(const Scene& scene, const Samples& samples)
    : x(samples.fluid),
      scene_(scene),
      boundary_(samples.boundary),
      h_(scene.spacing),
      H_(scene.smoothing * h_),
      m_(scene.rest_density * h_ * h_),
      rho0_(scene.rest_density),
      dt_(scene.dt) {
  const size_t n = x.size();
  for (size_t i = 0; i < n; ++i) {
    v.push_back(start_velocity(scene.fluid[samples.fluid_shape[i]], h_, x[i]));
  }
  p.assign(n, 0);
  rho = A_ii = s = p;
  a_n = v_star = a_p = std::vector<Vec2>(n);
}

double BruteForce::W(double r) const {
  const double q = r / H_, alpha = 5 / (14 * std::numbers::pi * H_ * H_);
  if (q < 1) return alpha * (std::pow(2 - q, 3) - 4 * std::pow(1 - q, 3));
  return q < 2 ? alpha * std::pow(2 - q, 3) : 0;
}

Vec2 BruteForce::dW(Vec2 x_ij) const {
  const double r = std::hypot(x_ij.x, x_ij.y), q = r / H_, alpha = 5 / (14 * std::numbers::pi * H_ * H_ * H_);
  if (r == 0 || q >= 2) return {0, 0};
  const double slope = q < 1 ? -3 * std::pow(2 - q, 2) + 12 * std::pow(1 - q, 2) : -3 * std::pow(2 - q, 2);
  return alpha * slope / r * x_ij;
}

void BruteForce::find_neighbours() {
  const auto among = [&](const std::vector<Vec2>& others, bool itself) {
    std::vector<std::vector<Neighbour>> all(x.size());
    for (uint32_t i = 0; i < x.size(); ++i) {
      for (uint32_t j = 0; j < others.size(); ++j) {
        const Vec2 x_ij = x[i] - others[j];
        const double r = std::hypot(x_ij.x, x_ij.y);
        if (r < 2 * H_ && !(itself && i == j)) all[i].push_back({j, x_ij, dW(x_ij), W(r)});
      }
    }
    return all;
  };
  fluid_neighbours_ = among(x, true);
  boundary_neighbours_ = among(boundary_, false);
}

void BruteForce::compute_density() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    rho[i] = m_ * W(0);
    for (const auto& j : fluid_neighbours_[i]) rho[i] += m_ * j.W;
    for (const auto& b : boundary_neighbours_[i]) rho[i] += m_ * b.W;
  }
}

void BruteForce::compute_non_pressure() {
  const double nu = scene_.viscosity_model == ViscosityModel::laplacian ? scene_.viscosity : 0;
  for (uint32_t i = 0; i < x.size(); ++i) {
    a_n[i] = scene_.gravity - scene_.central_force * (x[i] - scene_.centre);
    const auto term = [&](Vec2 v_ij, Vec2 x_ij, Vec2 gradient) {
      return glm::dot(v_ij, x_ij) / (glm::dot(x_ij, x_ij) + 0.01 * H_ * H_) * gradient;
    };
    for (const auto& j : fluid_neighbours_[i])
      a_n[i] += 2 * nu * m_ / rho[j.j] * term(v[i] - v[j.j], j.x_ij, j.dW);
    for (const auto& b : boundary_neighbours_[i]) a_n[i] += 2 * nu * m_ / rho[i] * term(v[i], b.x_ij, b.dW);
    v_star[i] = v[i] + dt_ * a_n[i];
  }
}

void BruteForce::compute_pressure_acceleration() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    a_p[i] = {0, 0};
    const double own = p[i] / (rho[i] * rho[i]);
    for (const auto& j : fluid_neighbours_[i]) a_p[i] -= m_ * (own + p[j.j] / (rho[j.j] * rho[j.j])) * j.dW;
    for (const auto& b : boundary_neighbours_[i]) a_p[i] -= m_ * (own + p[i] / (rho0_ * rho0_)) * b.dW;
  }
}

void BruteForce::solve() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    Vec2 sum{};
    double squares = 0, divergence = 0;
    for (const auto& j : fluid_neighbours_[i]) {
      sum += j.dW;
      squares += glm::dot(j.dW, j.dW);
      divergence += glm::dot(v_star[i] - v_star[j.j], j.dW);
    }
    for (const auto& b : boundary_neighbours_[i]) {
      sum += b.dW;
      squares += glm::dot(b.dW, b.dW);
      divergence += glm::dot(v_star[i], b.dW);
    }
    A_ii[i] = -dt_ * dt_ * m_ * m_ / (rho[i] * rho[i]) * (glm::dot(sum, sum) + squares);
    s[i] = scene_.iisph.source_weight * (rho0_ - rho[i]) - m_ * dt_ * divergence;
    p[i] *= scene_.iisph.warm_start;
  }
  iterations = 0;
  double error = 1;
  while ((error >= scene_.iisph.tolerance || iterations < scene_.iisph.min_iterations) &&
         iterations < scene_.iisph.max_iterations) {
    iterate(error);
    ++iterations;
  }
  residual = error;
}

void BruteForce::iterate(double& error) {
  compute_pressure_acceleration();
  double sum = 0;
  uint32_t counted = 0;
  for (uint32_t i = 0; i < x.size(); ++i) {
    double Ap = 0;
    for (const auto& j : fluid_neighbours_[i]) Ap += m_ * dt_ * dt_ * glm::dot(a_p[i] - a_p[j.j], j.dW);
    for (const auto& b : boundary_neighbours_[i]) Ap += m_ * dt_ * dt_ * glm::dot(a_p[i], b.dW);
    if (A_ii[i] == 0) continue;
    p[i] += scene_.iisph.omega * (s[i] - Ap) / A_ii[i];
    if (p[i] < 0) {
      p[i] = 0;
    } else {
      sum += std::abs(Ap - s[i]) / rho0_;
      ++counted;
    }
  }
  error = counted == 0 ? 0 : sum / counted;
}

void BruteForce::step() {
  find_neighbours();
  compute_density();
  compute_non_pressure();
  if (scene_.method == PressureMethod::iisph) {
    solve();
  } else {
    for (uint32_t i = 0; i < x.size(); ++i)
      p[i] = std::max(scene_.ssph->stiffness * (rho[i] / rho0_ - 1), 0.0);
  }
  compute_pressure_acceleration();
  for (uint32_t i = 0; i < x.size(); ++i) {
    v[i] = v_star[i] + dt_ * a_p[i];
    x[i] += dt_ * v[i];
  }
}

}  // namespace sluice::test
