// The list of shipped scenes in the window, to choose from.
#pragma once

#include <optional>
#include <string>

#include "apps/sluice/play/viewer.hpp"

namespace sluice::app {

constexpr glm::uvec2 menu_size{960, 720};  ///< size of its window, in pixels

/// Shows every shipped scene at its start, with a number. Returns the name of the one that was chosen by its
/// number or with the mouse, or nothing when the window was closed. EnvironmentError when there are no
/// shipped scenes.
std::optional<std::string> choose_scene(Viewer& viewer);

}  // namespace sluice::app
