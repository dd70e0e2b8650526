// Settings that several studies share, as overrides of a scene: docs/pressure_solvers.md.
#pragma once

#include <string>
#include <vector>

namespace sluice::study {

using Settings = std::vector<std::string>;

/// Both.
inline Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

/// IISPH's, recommended for everything but the thesis's scenes.
inline const Settings recommended{"pressure.iisph.solver=barzilai-borwein", "pressure.iisph.wall=symmetric",
                                  "pressure.iisph.warm_start=1"};

/// What makes them the settings for pressure.
inline const Settings quiet_pressure{"pressure.iisph.stop=residual", "pressure.iisph.tolerance=1e-2",
                                     "pressure.iisph.source_weight=0.2"};

}  // namespace sluice::study
