// Scene files: TOML in, a validated Scene out. The keys are in core/scene/keys.cpp.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sluice/error.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Loads a scene from the file at a path, or by the name of a scene that ships with Sluice. `overrides` are
/// "KEY=VALUE" texts, applied before anything is checked: docs/writing_a_scene.md.
/// Throws InputError, with one line that begins "FILE:LINE:COLUMN: key: " for a mistake in the file and
/// "--set KEY: key: " for one in an override.
Scene load_scene(const std::string& scene, std::span<const std::string> overrides = {});

inline Scene load_scene(const std::string& scene, std::initializer_list<std::string> overrides) {
  return load_scene(scene, std::span(overrides.begin(), overrides.size()));
}

/// The scene with more overrides, after those that it was loaded with. InputError as of load_scene.
Scene changed(const Scene& scene, std::span<const std::string> overrides);
inline Scene changed(const Scene& scene, std::initializer_list<std::string> overrides) {
  return changed(scene, std::span(overrides.begin(), overrides.size()));
}

/// Loads a scene from TOML text; `file` stands in messages, and its stem becomes the scene's name.
Scene parse_scene(std::string_view text, const std::string& file,
                  std::span<const std::string> overrides = {});

/// Names of the scenes that ship with Sluice, sorted. They are looked for in the source tree, beside the
/// installed program (../share/sluice/scenes) and where the library was to be installed.
std::vector<std::string> shipped_scenes();

}  // namespace sluice
