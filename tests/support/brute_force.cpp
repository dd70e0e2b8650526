// [Hunkler 2022], algorithms 5 to 9, and the [WCSPH page]: two boundary models, two viscosities, three
// methods, two wall terms, two solvers, two stop tests.
#include "tests/support/brute_force.hpp"

#include <algorithm>
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
      mirror_(scene.boundary_model != BoundaryModel::akinci),
      symmetric_(mirror_ && scene.method == PressureMethod::iisph && scene.iisph.wall == Wall::symmetric) {
  const size_t n = x.size();
  for (size_t i = 0; i < n; ++i) {
    v.push_back(start_velocity(scene, samples, i, x[i]));
  }
  p.assign(n, 0);
  rho = A_ii = s = reals[Field::A_ii] = p;
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

/// For particles without a direction between them: the steepest gradient, as if one were ahead of the other.
Vec2 BruteForce::parting(bool ahead) const {
  const Vec2 at = 2.0 / 3 * H_ * Vec2(0.8, 0.6);
  return ahead ? dW(at) : dW(-at);
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
        if (r >= 2 * H_ || (itself && i == j)) continue;
        const bool coincide = itself && r < 1e-4 * scene_.spacing;
        all[i].push_back({j, x_ij, coincide ? parting(i > j) : dW(x_ij), W(r)});
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
    const double mirrored = symmetric_ ? own : mirror_ ? p[i] / (rho0_ * rho0_) : 0;
    for (const auto& b : boundary_neighbours_[i]) a_p[i] -= boundary_mass[b.j] * (own + mirrored) * b.dW;
  }
}

/// m sum_j (u_i - u_j).dW_ij + sum_b m_b u_i.dW_ib, the last twice with the symmetric wall.
double BruteForce::divergence(const std::vector<Vec2>& u, uint32_t i) const {
  double sum = 0;
  for (const auto& j : fluid_neighbours_[i]) sum += m_ * glm::dot(u[i] - u[j.j], j.dW);
  for (const auto& b : boundary_neighbours_[i])
    sum += (symmetric_ ? 2 : 1) * boundary_mass[b.j] * glm::dot(u[i], b.dW);
  return sum;
}

void BruteForce::set_up_system() {
  for (uint32_t i = 0; i < x.size(); ++i) {
    Vec2 sum{};
    double squares = 0;
    for (const auto& j : fluid_neighbours_[i]) {
      sum += m_ * j.dW;
      squares += glm::dot(m_ * j.dW, m_ * j.dW);
    }
    for (const auto& b : boundary_neighbours_[i]) {
      const Vec2 gradient = boundary_mass[b.j] * b.dW;
      sum += (symmetric_ ? 2.0 : 1.0) * gradient;
      if (mirror_ && !symmetric_) squares += glm::dot(gradient, gradient);
    }
    A_ii[i] = -dt_ * dt_ / (rho[i] * rho[i]) * (glm::dot(sum, sum) + squares);
    s[i] = scene_.iisph.source_weight * (rho0_ - rho[i]) - dt_ * divergence(v_star, i);
    reals[Field::A_ii][i] = A_ii[i] * rho[i] * rho[i];
    p[i] *= scene_.iisph.warm_start;
  }
}

/// Errors of the p whose Ap this is.
BruteForce::Error BruteForce::error_of(const std::vector<double>& Ap) const {
  double sum = 0, squares = 0, source = 0;
  uint32_t counted = 0;
  for (uint32_t i = 0; i < x.size(); ++i) {
    if (A_ii[i] == 0) continue;
    const double r = s[i] - Ap[i];
    if (p[i] + scene_.iisph.omega * r / A_ii[i] >= 0) {
      sum += std::abs(r) / rho0_;
      ++counted;
    }
    const double wanted = p[i] > 0 ? r : std::min(r, 0.0);
    squares += wanted * wanted;
    source += std::min(s[i], 0.0) * std::min(s[i], 0.0);
  }
  const double relative = squares == 0 ? 0 : std::sqrt(squares) / std::sqrt(source);
  const double mean = counted == 0 ? 0 : sum / counted;
  return {scene_.iisph.stop == Stop::residual ? relative : mean, squares, source};
}

/// The step t of sweep k, the first being 0, from the last changes of p and Ap.
double BruteForce::step_of(uint32_t k, const std::vector<double>& Ap) const {
  if (scene_.iisph.solver == Solver::jacobi || k == 0) return scene_.iisph.omega;
  double SS = 0, SY = 0, YY = 0;
  for (uint32_t i = 0; i < x.size(); ++i) {
    if (A_ii[i] == 0) continue;
    const double rho_squared = rho[i] * rho[i], diagonal = A_ii[i] * rho_squared;
    const double S = (p[i] - p_before_[i]) / rho_squared, Y = (Ap[i] - Ap_before_[i]) / diagonal;
    SS += S * S * -diagonal;
    SY += S * Y * -diagonal;
    YY += Y * Y * -diagonal;
  }
  if (SY <= 0) return scene_.iisph.omega;
  return std::clamp(k % 2 == 1 ? SS / SY : SY / YY, 0.2, 1000.0);
}

void BruteForce::solve() {
  set_up_system();
  const Iisph& settings = scene_.iisph;
  std::vector<double> Ap(x.size()), best = p;
  double smallest = 0;
  bool has_best = false;
  iterations = 0;
  converged = false;
  for (bool goes_on = true; goes_on; ++iterations) {
    compute_pressure_acceleration();
    for (uint32_t i = 0; i < x.size(); ++i) Ap[i] = dt_ * dt_ * divergence(a_p, i);
    const auto [e, squares, source_squares] = error_of(Ap);
    const bool far_off = iterations == 0 && squares > 100 * source_squares;
    const bool is_best = !far_off && (!has_best || e < smallest);
    if (is_best) {
      has_best = true;
      smallest = e;
      best = p;
    }
    converged = e < settings.tolerance && !far_off;
    const uint32_t done = iterations + 1;
    goes_on = done < settings.max_iterations && (done < settings.min_iterations || !converged);
    residual = converged || !has_best ? e : smallest;
    const double t = goes_on ? step_of(iterations, Ap) : settings.omega;
    p_before_ = p;
    Ap_before_ = Ap;
    for (uint32_t i = 0; i < x.size(); ++i) {
      if (A_ii[i] != 0) p[i] = std::max(p[i] + t * (s[i] - Ap[i]) / A_ii[i], 0.0);
      if (far_off) p[i] = 0;
    }
    if (far_off) ++dropped;
    if (!goes_on && !converged && has_best && !is_best) {
      p = best;
      ++gone_back;
    }
  }
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
