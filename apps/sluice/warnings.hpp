// What a user should know of a run that is valid and yet may not be worth much.
#pragma once

#include <string>
#include <vector>

#include "apps/sluice/options.hpp"
#include "core/scene.hpp"
#include "core/summary.hpp"

namespace sluice {

/// One line on standard error, unless `quiet`.
void warn(bool quiet, const std::string& message);

/// Options for OpenGL in a run that neither computes nor draws with it.
void warn_of_unused_opengl(const MachineOptions& options, bool quiet);

/// What tends to go wrong and is known before the first step: an explicit viscosity, a state equation, the
/// pressure of deep fluid or XSPH beyond its limit, sound slower than the fluid, mirror walls of too few
/// layers.
std::vector<std::string> beyond_limits(const Scene& scene, const Samples& samples);

/// Why a run became invalid, where, and what often helps.
std::string failure_text(const Scene& scene, const RunStatistics& statistics, const Failure& failure);

/// Steps that did not converge, particles that moved too far or were lost, and where, a fluid that gives way.
void warn_of_poor_run(const Scene& scene, const RunStatistics& statistics, const std::vector<Loss>& losses,
                      bool quiet);

}  // namespace sluice
