// The lines of the overlay.
#include "apps/sluice/overlay_text.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace sluice::app {

std::vector<std::string> overlay_text(const Scene& scene, const Samples& samples, const StepReport& report,
                                      OverlayChoice overlay, double seconds_per_step) {
  if (overlay == OverlayChoice::none) return {};
  std::vector<std::string> lines = {scene.title,
                                    fmt::format("{}, dt {:g}", title_of(scene.method), report.dt),
                                    fmt::format("time {:.2f}", report.time)};
  if (scene.method == PressureMethod::iisph) lines.push_back(fmt::format("iterations {}", report.iterations));
  lines.push_back(fmt::format("particles {} + {}", samples.fluid.size(), samples.boundary.size()));
  if (overlay == OverlayChoice::all)
    lines.push_back(fmt::format("{:.2f} ms per step", 1e3 * seconds_per_step));
  return lines;
}

}  // namespace sluice::app
