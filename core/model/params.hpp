// All constants of a run, declared once: the CPU stages read ParamsOf<float> or ParamsOf<double>, the shaders
// a uniform block made from the same list. Derived constants are computed in double and rounded once.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace sluice {

struct Scene;

// clang-format off
/// REAL(name, meaning), VEC2(name, meaning), UINT(name, meaning)
#define SLUICE_PARAMS(REAL, VEC2, UINT)                                                                     \
  REAL(h, "particle spacing")                                                                               \
  REAL(m, "particle mass, rho0 h^2")                                                                        \
  REAL(rho0, "rest density")                                                                                \
  REAL(dt, "time step")                                                                                     \
  REAL(inverse_H, "1 / H, with H the smoothing length")                                                     \
  REAL(support_squared, "(2H)^2")                                                                           \
  REAL(kernel_factor, "5 / (14 pi H^2)")                                                                    \
  REAL(gradient_factor, "5 / (14 pi H^3)")                                                                  \
  REAL(coincidence, "1e-4 h: closer particles have no direction to be told apart by")                        \
  VEC2(parting_gradient, "kernel gradient of such a pair for the particle with the larger id")               \
  REAL(nu, "coefficient of the Laplacian viscosity")                                                        \
  REAL(viscosity_floor, "0.01 H^2, keeps the viscosity's denominator from vanishing")                       \
  REAL(xsph, "alpha m / dt, with alpha the coefficient of the XSPH viscosity")                              \
  REAL(k, "stiffness of the SSPH state equation")                                                           \
  REAL(tait_factor, "kappa rho0 / gamma of Tait's equation")                                                \
  REAL(gamma, "exponent of Tait's equation")                                                                \
  REAL(omega, "step of the Jacobi iteration, and of the first and the last of any")                         \
  REAL(warm_start, "share of the last step's pressure IISPH starts from")                                   \
  REAL(source_weight, "weight of rho0 - rho in the IISPH source")                                           \
  REAL(tolerance, "bound on the error e at which IISPH stops")                                              \
  REAL(wall_mass, "m where all boundary samples have it, 1 where each has a pseudo-mass of its own")        \
  REAL(wall_gradient_mass, "wall_mass, twice it where the symmetric system counts walls twice")             \
  REAL(wall_pressure, "1 / rho0^2 where a boundary sample mirrors the pressure, else 0")                    \
  REAL(central_force, "c in a = -c (x - centre)")                                                           \
  REAL(largest_move, "0.1 h, cap of one relaxation move")                                                   \
  REAL(inverse_cell, "1 / edge of a grid cell")                                                             \
  VEC2(gravity, "external acceleration")                                                                    \
  VEC2(centre, "centre of the central force, from the origin")                                              \
  VEC2(origin, "the scene's coordinates of position (0, 0), the domain's lower left corner; no stage needs it") \
  VEC2(extent, "width and height of the domain")                                                            \
  UINT(n, "number of fluid particles")                                                                      \
  UINT(min_iterations, "IISPH sweeps that are done in any case")                                            \
  UINT(max_iterations, "IISPH sweeps after which a solve ends, converged or not")                           \
  UINT(solver, "a Solver")                                                                                  \
  UINT(stop, "a Stop")                                                                                      \
  UINT(columns, "grid cells per row, padding included")                                                     \
  UINT(rows, "rows of grid cells, padding included")
// clang-format on

template <class Real>
struct ParamsOf {
#define REAL(name, meaning) Real name = 0;
#define VEC2(name, meaning) glm::vec<2, Real> name{};
#define UINT(name, meaning) uint32_t name = 0;
  SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT

  template <class Other>
  ParamsOf<Other> to() const {
    ParamsOf<Other> other;
#define REAL(name, meaning) other.name = static_cast<Other>(name);
#define VEC2(name, meaning) other.name = glm::vec<2, Other>(name);
#define UINT(name, meaning) other.name = name;
    SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT
    return other;
  }
};

using Params = ParamsOf<double>;

/// The constants of `scene` with `n` fluid particles.
Params make_params(const Scene& scene, uint32_t n);

/// Changes the time step and what depends on it.
void set_dt(Params& params, const Scene& scene, double dt);

/// The same for a relaxation of the positions: dt = 1, no external force, p starts at 0, s = rho0 - rho, and
/// a tolerance of its own.
Params make_relax_params(const Params& params, const Scene& scene);

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
