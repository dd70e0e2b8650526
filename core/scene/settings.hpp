// The settings of a scene as values.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sluice/scene.hpp"

namespace sluice {

/// Every key as run, defaults filled in, in the order of the key table.
nlohmann::ordered_json settings_of(const Scene& scene);

}  // namespace sluice
