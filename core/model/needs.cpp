// Scene -> Model -> Needs.
#include "core/model/needs.hpp"

#include "sluice/scene.hpp"

namespace sluice {

Model model_of(const Scene& scene) {
#define CHOICE(type, name, chosen, relaxing) chosen,
  return {SLUICE_MODEL(CHOICE)};
#undef CHOICE
}

Model Model::relaxing() const {
#define CHOICE(type, name, chosen, relaxing) relaxing,
  return {SLUICE_MODEL(CHOICE)};
#undef CHOICE
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
