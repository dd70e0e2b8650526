// [Hunkler 2022], algorithms 5 to 9, and the [WCSPH page]: two boundary models, two viscosities, three
// methods.
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
      dt_(scene.dt),
      mirror_(scene.boundary_model != BoundaryModel::akinci) {
  const size_t n = x.size();
  for (size_t i = 0; i < n; ++i) {
    v.push_back(start_velocity(scene.fluid[samples.fluid_shape[i]], h_, x[i]));
  }
  p.assign(n, 0);
  rho = A_ii = s = p;
  a_n = v_star = a_p = std::vector<Vec2>(n);
  compute_boundary_mass();
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

void BruteForce::compute_boundary_mass() {
  boundary_mass.assign(boundary_.size(), m_);
  if (mirror_) return;
  for (size_t b = 0; b < boundary_.size(); ++b) {
    double sum = 0;
    for (const Vec2 other : boundary_)
      sum += W(std::hypot(boundary_[b].x - other.x, boundary_[b].y - other.y));
    boundary_mass[b] = rho0_ / sum;
  }
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
    for (const auto& b : boundary_neighbours_[i]) rho[i] += boundary_mass[b.j] * b.W;
    if (scene_.method == PressureMethod::wcsph) rho[i] = std::max(rho[i], rho0_);
  }
}

void BruteForce::compute_non_pressure() {
  for (uint32_t i = 0; i < x.size(); ++i)
    a_n[i] = scene_.gravity - scene_.central_force * (x[i] - scene_.centre);
  if (scene_.viscosity_model == ViscosityModel::laplacian) add_viscosity();
  if (scene_.viscosity_model == ViscosityModel::xsph) add_xsph();
  for (uint32_t i = 0; i < x.size(); ++i) v_star[i] = v[i] + dt_ * a_n[i];
}

void BruteForce::add_viscosity() {
  const double nu = scene_.viscosity;
  const auto term = [&](Vec2 v_ij, Vec2 x_ij, Vec2 gradient) {
    return glm::dot(v_ij, x_ij) / (glm::dot(x_ij, x_ij) + 0.01 * H_ * H_) * gradient;
  };
  for (uint32_t i = 0; i < x.size(); ++i) {
    for (const auto& j : fluid_neighbours_[i])
      a_n[i] += 2 * nu * m_ / rho[j.j] * term(v[i] - v[j.j], j.x_ij, j.dW);
    for (const auto& b : boundary_neighbours_[i])
      a_n[i] += 2 * nu * boundary_mass[b.j] / rho[i] * term(v[i], b.x_ij, b.dW);
  }
}

void BruteForce::add_xsph() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    for (const auto& j : fluid_neighbours_[i])
      a_n[i] -= scene_.viscosity / dt_ * (m_ / rho[j.j]) * j.W * (v[i] - v[j.j]);
  }
}

void BruteForce::compute_pressure_acceleration() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    a_p[i] = {0, 0};
    const double own = p[i] / (rho[i] * rho[i]);
    for (const auto& j : fluid_neighbours_[i]) a_p[i] -= m_ * (own + p[j.j] / (rho[j.j] * rho[j.j])) * j.dW;
    const double mirrored = mirror_ ? p[i] / (rho0_ * rho0_) : 0;
    for (const auto& b : boundary_neighbours_[i]) a_p[i] -= boundary_mass[b.j] * (own + mirrored) * b.dW;
  }
}

void BruteForce::solve() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    Vec2 sum{};
    double squares = 0, divergence = 0;
    for (const auto& j : fluid_neighbours_[i]) {
      sum += m_ * j.dW;
      squares += glm::dot(m_ * j.dW, m_ * j.dW);
      divergence += m_ * glm::dot(v_star[i] - v_star[j.j], j.dW);
    }
    for (const auto& b : boundary_neighbours_[i]) {
      const Vec2 gradient = boundary_mass[b.j] * b.dW;
      sum += gradient;
      if (mirror_) squares += glm::dot(gradient, gradient);
      divergence += glm::dot(v_star[i], gradient);
    }
    A_ii[i] = -dt_ * dt_ / (rho[i] * rho[i]) * (glm::dot(sum, sum) + squares);
    s[i] = scene_.iisph.source_weight * (rho0_ - rho[i]) - dt_ * divergence;
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
    for (const auto& b : boundary_neighbours_[i])
      Ap += boundary_mass[b.j] * dt_ * dt_ * glm::dot(a_p[i], b.dW);
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

void BruteForce::compute_pressure() {
  if (scene_.method == PressureMethod::iisph) return solve();
  for (uint32_t i = 0; i < x.size(); ++i) {
    const double ratio = rho[i] / rho0_;
    if (scene_.method == PressureMethod::ssph) {
      p[i] = std::max(scene_.ssph->stiffness * (ratio - 1), 0.0);
    } else {
      const auto [kappa, gamma] = *scene_.wcsph;
      p[i] = kappa * rho0_ / gamma * (std::pow(ratio, gamma) - 1);
    }
  }
}

void BruteForce::step() {
  find_neighbours();
  compute_density();
  compute_non_pressure();
  compute_pressure();
  compute_pressure_acceleration();
  for (uint32_t i = 0; i < x.size(); ++i) {
    v[i] = v_star[i] + dt_ * a_p[i];
    x[i] += dt_ * v[i];
  }
}

}  // namespace sluice::test
