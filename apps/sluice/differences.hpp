// Where the settings of two scenes differ.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace sluice::app {

struct Difference {
  std::string key;          ///< as for --set: "fluid.rect.0.max"
  std::string before, now;  ///< the values as JSON, or "none"
};

/// First difference, in the order of `before`, that counts for the steps: not one in output, in scene or in
/// time.duration.
std::optional<Difference> first_difference(const nlohmann::ordered_json& before,
                                           const nlohmann::ordered_json& now);

}  // namespace sluice::app
