// All constants of a run, declared once: the CPU stages read ParamsOf<float> or ParamsOf<double>, the shaders
// a uniform block made from the same list. Derived constants are computed in double and rounded once.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace sluice {

struct Scene;

// clang-format off
/// REAL(name, value, meaning), VEC2(name, value, meaning), UINT(name, value, meaning). A value is computed from
/// the rows above it and from what params.cpp names before the rows.
#define SLUICE_PARAMS(REAL, VEC2, UINT)                                                                                        \
  REAL(h, scene.spacing, "particle spacing")                                                                                   \
  REAL(m, scene.mass(), "particle mass, rho0 h^2")                                                                             \
  REAL(rho0, scene.rest_density, "rest density")                                                                               \
  REAL(dt, step, "time step")                                                                                                  \
  REAL(inverse_H, 1 / H, "1 / H, with H the smoothing length")                                                                 \
  REAL(support_squared, 4 * H * H, "(2H)^2")                                                                                   \
  REAL(kernel_factor, 5 / (14 * std::numbers::pi * H * H), "5 / (14 pi H^2)")                                                  \
  REAL(gradient_factor, 5 / (14 * std::numbers::pi * H * H * H), "5 / (14 pi H^3)")                                            \
  REAL(coincidence, 1e-4 * h, "1e-4 h: closer particles have no direction to be told apart by")                                \
  VEC2(parting_gradient, -4 * gradient_factor * parting_direction,                                                             \
       "kernel gradient of such a pair for the particle with the larger id")                                                   \
  REAL(nu, laplacian ? scene.viscosity : 0, "coefficient of the Laplacian viscosity")                                          \
  REAL(viscosity_floor, 0.01 * H * H, "0.01 H^2, keeps the viscosity's denominator from vanishing")                            \
  REAL(xsph, smoothed ? scene.viscosity * m / dt : 0, "alpha m / dt, with alpha the coefficient of the XSPH viscosity")        \
  REAL(k, scene.ssph ? scene.ssph->stiffness : 0, "stiffness of the SSPH state equation")                                      \
  REAL(gamma, scene.wcsph ? scene.wcsph->gamma : 0, "exponent of Tait's equation")                                             \
  REAL(tait_factor, scene.wcsph ? scene.wcsph->kappa * rho0 / gamma : 0, "kappa rho0 / gamma of Tait's equation")              \
  REAL(omega, scene.iisph.omega, "step of the Jacobi iteration, and of the first and the last of any")                         \
  REAL(warm_start, scene.iisph.warm_start, "share of the last step's pressure IISPH starts from")                              \
  REAL(source_weight, scene.iisph.source_weight, "weight of rho0 - rho in the IISPH source")                                   \
  REAL(tolerance, scene.iisph.tolerance, "bound on the error e at which IISPH stops")                                          \
  REAL(wall_mass, akinci ? 1 : m, "m where all boundary samples have it, 1 where each has a pseudo-mass of its own")           \
  REAL(wall_gradient_mass, symmetric ? 2 * wall_mass : wall_mass,                                                              \
       "wall_mass, twice it where the symmetric system counts walls twice")                                                    \
  REAL(wall_pressure, mirror && !symmetric ? 1 / (rho0 * rho0) : 0,                                                            \
       "1 / rho0^2 where a boundary sample mirrors the pressure, else 0")                                                      \
  REAL(central_force, scene.central_force, "c in a = -c (x - centre)")                                                         \
  REAL(largest_move, 0.1 * h, "0.1 h, cap of one relaxation move")                                                             \
  REAL(inverse_cell, 1 / cell_edge(scene), "1 / edge of a grid cell")                                                          \
  VEC2(gravity, scene.gravity, "external acceleration")                                                                        \
  VEC2(origin, scene.domain_min,                                                                                               \
       "the scene's coordinates of position (0, 0), the domain's lower left corner; no stage needs it")                        \
  VEC2(centre, scene.centre - origin, "centre of the central force, from the origin")                                          \
  VEC2(extent, scene.domain_max - scene.domain_min, "width and height of the domain")                                          \
  UINT(n, particles, "number of fluid particles")                                                                              \
  UINT(min_iterations, scene.iisph.min_iterations, "IISPH sweeps that are done in any case")                                   \
  UINT(max_iterations, scene.iisph.max_iterations, "IISPH sweeps after which a solve ends, converged or not")                  \
  UINT(solver, uint32_t(scene.iisph.solver), "a Solver")                                                                       \
  UINT(stop, uint32_t(scene.iisph.stop), "a Stop")                                                                             \
  UINT(columns, uint32_t(cells.x), "grid cells per row, padding included")                                                     \
  UINT(rows, uint32_t(cells.y), "rows of grid cells, padding included")
// clang-format on

template <class Real>
struct ParamsOf {
#define REAL(name, value, meaning) Real name = 0;
#define VEC2(name, value, meaning) glm::vec<2, Real> name{};
#define UINT(name, value, meaning) uint32_t name = 0;
  SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT

  template <class Other>
  ParamsOf<Other> to() const {
    ParamsOf<Other> other;
#define REAL(name, value, meaning) other.name = static_cast<Other>(name);
#define VEC2(name, value, meaning) other.name = glm::vec<2, Other>(name);
#define UINT(name, value, meaning) other.name = name;
    SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT
    return other;
  }
};

using Params = ParamsOf<double>;

/// The constants of `scene` with `particles` fluid particles and the time step `step`, or that it begins
/// with.
Params make_params(const Scene& scene, uint32_t particles, double step);
Params make_params(const Scene& scene, uint32_t particles);

/// Constants of a relaxation of the positions: dt = 1, no external force, p starts at 0, s = rho0 - rho, and
/// a tolerance of its own.
Params make_relax_params(const Scene& scene, uint32_t particles);

/// Grid cells along the edges of the scene's domain, padding included; as doubles, so that nothing overflows.
glm::dvec2 grid_cells(const Scene& scene);

/// Cell of position x, padding included. Positions outside the grid belong to its outermost cells: the clamp
/// is monotone, so neighbours stay neighbours. NaN goes to the first cell.
template <class Real>
uint32_t cell_of(const ParamsOf<Real>& params, glm::vec<2, Real> x) {
  const auto along = [&](Real at, uint32_t padded) {
    const Real last = static_cast<Real>(padded - 3);
    Real t = at * params.inverse_cell;
    t = t > Real(0) ? t : Real(0);
    t = t < last ? t : last;
    return static_cast<uint32_t>(t) + 1u;
  };
  return along(x.y, params.rows) * params.columns + along(x.x, params.columns);
}

/// Whether a particle at x is lost: left of, right of or below the domain. Above an open top it may come
/// back.
template <class Real>
bool is_lost(const ParamsOf<Real>& params, glm::vec<2, Real> x) {
  return x.x < 0 || x.x > params.extent.x || x.y < 0;
}

}  // namespace sluice
