// What is written over a picture of a run.
#pragma once

#include <string>
#include <vector>

#include "apps/sluice/options.hpp"
#include "sluice/report.hpp"
#include "sluice/sampling.hpp"

namespace sluice::app {

/// Lines on a picture: title, method, time, iterations, particles; with `all` also the wall time of the step.
std::vector<std::string> overlay_text(const Scene& scene, const Samples& samples, const StepReport& report,
                                      OverlayChoice overlay, double seconds_per_step);

}  // namespace sluice::app
