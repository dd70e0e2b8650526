// What a scene asks of the model, as a table of needs. Stages, fields and shaders refer to needs by name;
// what no need of a scene asks for is not planned, not allocated and not compiled.
#pragma once

#include <array>
#include <string_view>

#include "sluice/choices.hpp"

namespace sluice {

struct Scene;

// clang-format off
/// CHOICE(type, name, what a scene chooses, what is chosen while its start is relaxed: then the fluid is
/// inviscid, and its pressure comes from the linear system). The type is an enum of choices.hpp or bool.
#define SLUICE_MODEL(CHOICE)                                                                                            \
  CHOICE(BoundaryModel, boundary, scene.boundary.empty() ? BoundaryModel::none : scene.boundary_model, boundary)        \
  CHOICE(ViscosityModel, viscosity, scene.viscosity > 0 ? scene.viscosity_model : ViscosityModel::none, ViscosityModel::none) \
  CHOICE(PressureMethod, method, scene.method, PressureMethod::iisph)                                                   \
  CHOICE(Wall, wall, scene.iisph.wall, wall)                                                                            \
  CHOICE(Solver, solver, scene.iisph.solver, solver)
// clang-format on

/// The choices of a scene that decide what a step is made of.
struct Model {
#define CHOICE(type, name, chosen, relaxing) type name{};
  SLUICE_MODEL(CHOICE)
#undef CHOICE

  /// The model of a relaxation of the positions.
  Model relaxing() const;
};

Model model_of(const Scene& scene);

// clang-format off
/// NEED(name, when a Model has it, meaning)
#define SLUICE_NEEDS(NEED)                                                                                              \
  NEED(always, true, "every scene")                                                                                     \
  NEED(boundary, model.boundary != BoundaryModel::none, "boundary samples")                                             \
  NEED(pseudo_mass, model.boundary == BoundaryModel::akinci, "boundary samples with masses of their own")               \
  NEED(laplacian, model.viscosity == ViscosityModel::laplacian, "viscosity by the Laplacian")                           \
  NEED(wall_viscosity, boundary && laplacian, "viscosity at the boundary")                                              \
  NEED(xsph, model.viscosity == ViscosityModel::xsph, "viscosity by XSPH")                                              \
  NEED(state_equation, model.method == PressureMethod::ssph, "pressure from the state equation of SSPH")                \
  NEED(tait, model.method == PressureMethod::wcsph, "pressure from Tait's equation")                                    \
  NEED(linear_system, model.method == PressureMethod::iisph, "pressure from the linear system of IISPH")                \
  NEED(thesis_wall, linear_system && model.boundary == BoundaryModel::mirror && model.wall == Wall::thesis,             \
       "mirror samples that the pressure system counts once")                                                           \
  NEED(barzilai_borwein, linear_system && model.solver == Solver::barzilai_borwein, "steps of the Barzilai-Borwein kind")
// clang-format on

/// Which needs a model has: a bool per row of the table.
struct Needs {
#define NEED(name, condition, meaning) bool name = false;
  SLUICE_NEEDS(NEED)
#undef NEED

  bool operator==(const Needs&) const = default;
};

/// One of the needs, to be looked up in any Needs: needs.*need.
using Need = bool Needs::*;

struct NeedInfo {
  std::string_view name;
  Need need;
  std::string_view meaning;
};
inline constexpr auto need_table = std::to_array<NeedInfo>({
#define NEED(name, condition, meaning) {#name, &Needs::name, meaning},
    SLUICE_NEEDS(NEED)
#undef NEED
});

Needs needs_of(const Model& model);
Needs needs_of(const Scene& scene);

}  // namespace sluice
