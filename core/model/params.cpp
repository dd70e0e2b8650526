// Scene -> constants of a run. The grid covers the domain with cells of 2H.
#include "core/model/params.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/scene/scene.hpp"

namespace sluice {
namespace {

constexpr double relax_tolerance = 1e-4;

/// A unit vector, along none of the axes that lattices and walls have.
constexpr glm::dvec2 parting_direction{0.8, 0.6};

/// Edge of a grid cell: 2H, widened by what rounding a position's cell coordinate to float can cost, so that
/// two particles in reach of each other never lie more than one cell apart.
double cell_edge(const Scene& scene) {
  const double support = 2 * scene.smoothing_length();
  const glm::dvec2 extent = scene.domain_max - scene.domain_min;
  const double cells = std::max(extent.x, extent.y) / support + 1;
  return support * (1 + 4 * double(std::numeric_limits<float>::epsilon()) * cells);
}

/// The wall term of the scene's pressure system.
void set_wall(Params& p, const Scene& scene) {
  if (scene.boundary_model != BoundaryModel::mirror || scene.iisph.wall != Wall::symmetric) return;
  p.wall_gradient_mass = 2 * p.wall_mass;
  p.wall_pressure = 0;
}

}  // namespace

glm::dvec2 grid_cells(const Scene& scene) {
  return glm::ceil((scene.domain_max - scene.domain_min) / cell_edge(scene)) + 2.0;
}

void set_dt(Params& params, const Scene& scene, double dt) {
  params.dt = dt;
  params.xsph = scene.viscosity_model == ViscosityModel::xsph ? scene.viscosity * params.m / dt : 0;
}

Params make_params(const Scene& scene, uint32_t n) {
  const double H = scene.smoothing_length();
  Params p;
  p.h = scene.spacing;
  p.m = scene.mass();
  p.rho0 = scene.rest_density;
  p.inverse_H = 1 / H;
  p.support_squared = 4 * H * H;
  p.kernel_factor = 5 / (14 * std::numbers::pi * H * H);
  p.gradient_factor = 5 / (14 * std::numbers::pi * H * H * H);
  p.coincidence = 1e-4 * p.h;
  p.parting_gradient = -4 * p.gradient_factor * parting_direction;
  p.nu = scene.viscosity_model == ViscosityModel::laplacian ? scene.viscosity : 0;
  p.viscosity_floor = 0.01 * H * H;
  set_dt(p, scene, scene.dt);
  p.k = scene.ssph ? scene.ssph->stiffness : 0;
  if (scene.wcsph) {
    p.gamma = scene.wcsph->gamma;
    p.tait_factor = scene.wcsph->kappa * p.rho0 / p.gamma;
  }
  p.omega = scene.iisph.omega;
  p.warm_start = scene.iisph.warm_start;
  p.source_weight = scene.iisph.source_weight;
  p.tolerance = scene.iisph.tolerance;
  p.wall_mass = scene.boundary_model == BoundaryModel::akinci ? 1 : p.m;
  const bool mirror = scene.boundary_model == BoundaryModel::mirror;
  p.wall_gradient_mass = p.wall_mass;
  p.wall_pressure = mirror ? 1 / (p.rho0 * p.rho0) : 0;
  if (scene.method == PressureMethod::iisph) set_wall(p, scene);
  p.central_force = scene.central_force;
  p.largest_move = 0.1 * p.h;
  p.inverse_cell = 1 / cell_edge(scene);
  p.gravity = scene.gravity;
  p.origin = scene.domain_min;
  p.centre = scene.centre - p.origin;
  p.extent = scene.domain_max - scene.domain_min;
  p.n = n;
  p.min_iterations = scene.iisph.min_iterations;
  p.max_iterations = scene.iisph.max_iterations;
  p.solver = static_cast<uint32_t>(scene.iisph.solver);
  p.stop = static_cast<uint32_t>(scene.iisph.stop);
  const glm::dvec2 cells = grid_cells(scene);
  p.columns = static_cast<uint32_t>(cells.x);
  p.rows = static_cast<uint32_t>(cells.y);
  return p;
}

Params make_relax_params(const Params& params, const Scene& scene) {
  Params p = params;
  set_wall(p, scene);
  p.dt = 1;
  p.gravity = {};
  p.central_force = 0;
  p.warm_start = 0;
  p.source_weight = 1;
  p.tolerance = relax_tolerance;
  p.stop = static_cast<uint32_t>(Stop::density);
  return p;
}

}  // namespace sluice
