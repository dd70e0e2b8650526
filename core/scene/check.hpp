// Checks a scene's tree against the key table, value by value, and fills in the defaults.
#pragma once

#include "core/scene/tree.hpp"

namespace sluice {

/// Refuses unknown keys, missing keys and tables, values of the wrong type or out of range, malformed
/// lengths. Every table is checked, used or not. Afterwards every key that has a default is in the tree, in
/// the tables that were written and in those that are always there. Throws InputError. What several keys must
/// fulfil together is left to build_scene.
void check_scene(SceneValue& root);

}  // namespace sluice
