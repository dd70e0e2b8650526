// `sluice scenes`: the shipped scenes, or the reference of all keys.
#include <fmt/format.h>

#include "apps/sluice/commands.hpp"
#include "core/scene/keys.hpp"
#include "core/text.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"

namespace sluice::app {

int scenes_command(bool keys) {
  if (keys) {
    fmt::print("{}", key_reference());
    return 0;
  }
  fmt::print("{:<24}{:>8}{:>10}  {:<8}{:>8}{:>10}  {}\n", "scene", "fluid", "boundary", "method", "dt",
             "duration", "title");
  for (const std::string& name : shipped_scenes()) {
    const Scene scene = load_scene(name);
    const Samples samples = sample(scene);
    fmt::print("{:<24}{:>8}{:>10}  {:<8}{:>8g}{:>10g}  {}\n", name, samples.fluid.size(),
               samples.boundary.size(), name_of(scene.method), scene.dt, scene.duration, scene.title);
  }
  return 0;
}

}  // namespace sluice::app
