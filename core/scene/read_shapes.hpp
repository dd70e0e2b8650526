// What a checked scene tree says in lengths, as values in numbers.
#pragma once

#include "core/scene/scene.hpp"
#include "core/scene/tree.hpp"

namespace sluice {

/// Reads the domain, the centre of the central force and all shapes, [[fluid.*]] and [[boundary.*]]. Throws
/// InputError.
void read_lengths(const SceneValue& root, Scene& scene);

/// The value of a checked [x, y] of numbers.
Vec2 numbers(const SceneValue& pair);

}  // namespace sluice
