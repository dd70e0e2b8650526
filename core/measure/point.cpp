// Sums over the particles in reach of a point, in double.
#include "core/measure/point.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/measure/kernel.hpp"

namespace sluice {
namespace {

/// Determinant of the fit's matrix, divided by that of a particle's surroundings on a lattice, from which on
/// it is solved.
constexpr double determined = 1e-3;
constexpr double half = 0.5;

/// f(j, x_j - at, W_j) for the particles within 2H.
template <class F>
void for_each_in_reach(const Scene& scene, const Snapshot& state, Vec2 at, F&& f) {
  const Params params = make_params(scene, static_cast<uint32_t>(state.x.size()));
  const double reach = 2 * scene.smoothing_length();
  for (size_t j = 0; j < state.x.size(); ++j) {
    const Vec2 apart = state.x[j] - at;
    if (!(std::abs(apart.x) < reach && std::abs(apart.y) < reach)) continue;
    if (const double r = glm::length(apart); r < reach) f(j, apart, kernel(params, r));
  }
}

double volume(const Scene& scene, const Snapshot& state, size_t j) {
  return scene.mass() / (state.density[j] > 0 ? state.density[j] : scene.rest_density);
}

/// The largest t, from `high` down to `low`, at which share(t) is a half.
template <class Share>
std::optional<double> last_half(double low, double high, double step, Share&& share) {
  double above = high;
  for (double t = high; t >= low - step; t -= step) {
    if (share(t) >= half) {
      double inside = t, outside = above;
      for (int k = 0; k < 30 && t < high; ++k) {
        const double middle = (inside + outside) / 2;
        (share(middle) >= half ? inside : outside) = middle;
      }
      return inside;
    }
    above = t;
  }
  return std::nullopt;
}

/// Where the fluid ends along the axis `along` at the coordinate `place` of the other one.
std::optional<double> end_of_fluid(const Scene& scene, const Snapshot& state, int along, double place) {
  const int across = 1 - along;
  const double reach = 2 * scene.smoothing_length();
  Snapshot near;
  for (size_t j = 0; j < state.x.size(); ++j) {
    if (!(std::abs(state.x[j][across] - place) < reach)) continue;
    near.x.push_back(state.x[j]);
    near.density.push_back(state.density[j]);
  }
  if (near.x.empty()) return std::nullopt;
  double low = near.x.front()[along], high = low;
  for (const Vec2 x : near.x) low = std::min(low, x[along]), high = std::max(high, x[along]);
  return last_half(low, high + reach, scene.spacing / 4, [&](double t) {
    Vec2 at;
    at[along] = t;
    at[across] = place;
    return share_at(scene, near, at);
  });
}

}  // namespace

PointValues values_at(const Scene& scene, const Snapshot& state, Vec2 at) {
  using Fit = glm::dvec4;  // pressure, density, velocity
  const double H = scene.smoothing_length();
  glm::dmat3 matrix(0);
  glm::dmat3x4 sums(0);  // of the values times 1, x, y
  Fit weighted(0);
  double weights = 0;
  for_each_in_reach(scene, state, at, [&](size_t j, Vec2 apart, double W) {
    const glm::dvec3 basis(1, apart / H);
    const Fit values(state.pressure[j], state.density[j], state.v[j]);
    const double w = W * scene.spacing * scene.spacing;
    matrix += w * glm::outerProduct(basis, basis);
    for (int k = 0; k < 3; ++k) sums[k] += w * basis[k] * values;
    weights += volume(scene, state, j) * W;
    weighted += volume(scene, state, j) * W * values;
  });
  if (!(weights > 0)) return {};
  const double scale = matrix[0][0];
  const bool fits = glm::determinant(matrix) > determined * scale * scale * scale;
  // The value of the fit at the point is its constant.
  const Fit value = fits ? sums * glm::inverse(matrix)[0] : weighted / weights;
  return {value[0], value[1], {value[2], value[3]}};
}

double share_at(const Scene& scene, const Snapshot& state, Vec2 at) {
  double share = 0;
  for_each_in_reach(scene, state, at,
                    [&](size_t j, Vec2, double W) { share += volume(scene, state, j) * W; });
  return share;
}

std::optional<double> level_at(const Scene& scene, const Snapshot& state, double x) {
  return end_of_fluid(scene, state, 1, x);
}

std::optional<double> front_at(const Scene& scene, const Snapshot& state, double y) {
  return end_of_fluid(scene, state, 0, y);
}

}  // namespace sluice
