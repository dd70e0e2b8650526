// A checked tree to a Scene: lengths are evaluated, and what several keys must fulfil together is checked.
#pragma once

#include <string>

#include "core/scene/scene.hpp"
#include "core/scene/tree.hpp"

namespace sluice {

/// The scene that a tree describes, after check_scene. `name` and `file` become Scene::name and Scene::file.
/// Throws InputError where keys contradict each other, where a length is not finite, and where a shape would
/// hold more samples than can be numbered.
Scene build_scene(const SceneValue& root, const std::string& name, const std::string& file);

/// The scene as run, as JSON: every key of the tree in the order of the key table, defaults included; numbers
/// as numbers, length strings as written. `scene` gives what no key says by itself: the time step and the
/// picture's size.
std::string settings_text(const SceneValue& root, const Scene& scene);

}  // namespace sluice
