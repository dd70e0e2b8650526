// What is done to the tree of a scene, in this order, until it is a Scene.
#pragma once

#include <span>
#include <string>

#include "core/scene/tree.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Applies "KEY=VALUE" overrides in their order; the last one for a key wins. A part of KEY that is a number
/// is an index into an array, and the index after the last appends. Missing tables and arrays on the way are
/// made. Setting time.dt removes time.cfl, time.dt_min, time.dt_max and every method's dt; setting time.cfl
/// removes time.dt and every method's dt; the later of the two wins. Throws InputError for text that isn't
/// KEY=VALUE, and for a KEY that leads through a plain value or past the end of an array. Whether KEY exists
/// in a scene is left to check_scene.
void apply_overrides(SceneValue& root, std::span<const std::string> overrides);

/// Refuses unknown keys, missing keys and tables, values of the wrong type or out of range, malformed
/// lengths. Every table is checked, used or not. Afterwards every key that has a default is in the tree, in
/// the tables that were written and in those that are always there. Throws InputError. What several keys must
/// fulfil together is left to build_scene.
void check_scene(SceneValue& root);

/// The scene that a checked tree describes. `name` and `file` become Scene::name and Scene::file. Throws
/// InputError where keys contradict each other, where a length is not finite, and where a shape would hold
/// more samples than can be numbered.
Scene build_scene(const SceneValue& root, const std::string& name, const std::string& file);

/// A part of build_scene: the domain, the centre of the central force and all shapes, [[fluid.*]] and
/// [[boundary.*]].
void read_lengths(const SceneValue& root, Scene& scene);

/// The value of a checked [x, y] of numbers.
Vec2 vector_of(const SceneValue& pair);

}  // namespace sluice
