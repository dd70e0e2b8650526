// What is chosen with keys in `sluice play`, and the scene that comes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sluice/scene.hpp"

namespace sluice::app {

/// Choice of the user: a scene as its file has it, changed by the command line, and by keys.
struct Choice {
  std::string scene;
  std::vector<std::string> overrides;
  std::optional<PressureMethod> method;
  double refinement = 1;  ///< spacing over that of the file
  double dt_factor = 1;   ///< dt over that of the file, beyond what the spacing asks for
};

/// Loads the scene of a choice. The time step follows the spacing, and with a finer one stays below the limit
/// of an explicit viscosity; lattices given by `count` keep their size. InputError as of load_scene.
Scene load_choice(const Choice& choice);

/// Choice with another method and that method's own time step. InputError when `scene`, which was made of the
/// choice, has no table for it.
Choice with_method(Choice choice, PressureMethod method, const Scene& scene);

}  // namespace sluice::app
