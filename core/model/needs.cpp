// Scene -> Model -> Needs.
#include "core/model/needs.hpp"

#include "core/scene/scene.hpp"

namespace sluice {

Model model_of(const Scene& scene) {
  Model model;
  if (!scene.boundary.empty()) model.boundary = scene.boundary_model;
  if (scene.viscosity > 0) model.viscosity = scene.viscosity_model;
  model.method = scene.method;
  model.wall = scene.iisph.wall;
  model.solver = scene.iisph.solver;
  return model;
}

Needs needs_of(const Model& model) {
#define NEED(name, condition, meaning) const bool name = condition;
  SLUICE_NEEDS(NEED)
#undef NEED
  return {
#define NEED(name, condition, meaning) name,
      SLUICE_NEEDS(NEED)
#undef NEED
  };
}

Needs needs_of(const Scene& scene) { return needs_of(model_of(scene)); }

}  // namespace sluice
