// Scene -> constants of a run. The grid covers the domain with cells of 2H.
#include "core/model/params.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/model/needs.hpp"
#include "sluice/scene.hpp"

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

/// The constants of a scene, or of a relaxation of its start, as the model says.
Params make(const Scene& scene, const Model& model, uint32_t particles, double step) {
  const double H = scene.smoothing_length();
  const bool laplacian = model.viscosity == ViscosityModel::laplacian;
  const bool smoothed = model.viscosity == ViscosityModel::xsph;
  const bool akinci = scene.boundary_model == BoundaryModel::akinci;
  const bool mirror = scene.boundary_model == BoundaryModel::mirror;
  const bool symmetric = mirror && model.method == PressureMethod::iisph && model.wall == Wall::symmetric;
  const glm::dvec2 cells = grid_cells(scene);
#define REAL(name, value, meaning) const double name = value;
#define VEC2(name, value, meaning) const glm::dvec2 name = value;
#define UINT(name, value, meaning) const uint32_t name = value;
  SLUICE_PARAMS(REAL, VEC2, UINT)
#undef REAL
#undef VEC2
#undef UINT
#define NAME(name, value, meaning) name,
  return {SLUICE_PARAMS(NAME, NAME, NAME)};
#undef NAME
}

}  // namespace

glm::dvec2 grid_cells(const Scene& scene) {
  return glm::ceil((scene.domain_max - scene.domain_min) / cell_edge(scene)) + 2.0;
}

Params make_params(const Scene& scene, uint32_t particles, double step) {
  return make(scene, model_of(scene), particles, step);
}

Params make_params(const Scene& scene, uint32_t particles) { return make_params(scene, particles, scene.dt); }

Params make_relax_params(const Scene& scene, uint32_t particles) {
  Params p = make(scene, model_of(scene).relaxing(), particles, 1);
  p.gravity = {};
  p.central_force = 0;
  p.warm_start = 0;
  p.source_weight = 1;
  p.tolerance = relax_tolerance;
  p.stop = uint32_t(Stop::density);
  return p;
}

}  // namespace sluice
