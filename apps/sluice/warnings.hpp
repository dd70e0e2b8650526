// What a user should know of a run that is valid and yet may not be worth much.
#pragma once

#include <string>

#include "apps/sluice/options.hpp"
#include "core/scene.hpp"
#include "core/summary.hpp"

namespace sluice {

/// One line on standard error, unless `quiet`.
void warn(bool quiet, const std::string& message);

/// Options for OpenGL in a run that neither computes nor draws with it.
void warn_of_unused_opengl(const MachineOptions& options, bool quiet);

/// What tends to go wrong and is known before the first step: an explicit viscosity, a state equation or XSPH
/// beyond its limit, mirror walls of too few layers.
void warn_of_limits(const Scene& scene, bool quiet);

/// What often helps against a run that became invalid in `step`.
std::string remedy(const Scene& scene, const RunStatistics& statistics, uint64_t step);

/// Steps that did not converge, particles that moved too far or were lost, a fluid that gives way.
void warn_of_poor_run(const RunStatistics& statistics, bool quiet);

}  // namespace sluice
