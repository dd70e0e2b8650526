// --set KEY=VALUE: changes to a scene made before it is checked.
#pragma once

#include <span>
#include <string>

#include "core/scene/tree.hpp"

namespace sluice {

/// Applies "KEY=VALUE" overrides in their order; the last one for a key wins. A part of KEY that is a number
/// is an index into an array, and the index after the last appends. Missing tables and arrays on the way are
/// made. Setting time.dt removes time.cfl, time.dt_min, time.dt_max and every method's dt; setting time.cfl
/// removes time.dt and every method's dt; the later of the two wins. Throws InputError for text that isn't
/// KEY=VALUE, and for a KEY that leads through a plain value or past the end of an array. Whether KEY exists
/// in a scene is left to check_scene.
void apply_overrides(SceneValue& root, std::span<const std::string> overrides);

}  // namespace sluice
