// What a user should know of a run that is valid and yet may not be worth much.
#pragma once

#include <string>

#include "apps/sluice/options.hpp"
#include "core/output/summary.hpp"
#include "core/solver/limits.hpp"
#include "sluice/scene.hpp"

namespace sluice::app {

/// Writes one line to standard error, unless `quiet`.
void warn(bool quiet, const std::string& message);

/// Warns of options for OpenGL in a run that neither computes nor draws with it.
void warn_of_unused_opengl(const MachineOptions& options, bool quiet);

/// Text that says why a run became invalid, where, and what often helps.
std::string failure_text(const Scene& scene, const RunStatistics& statistics, const Failure& failure);

/// Warns of the particles that left the domain, if any did, with the place and the moment.
void warn_of_losses(const RunStatistics& statistics, const std::vector<Loss>& losses, bool quiet);

/// Warns of steps that did not converge, of particles that moved too far or were lost, and where, and of a
/// fluid that gives way.
void warn_of_poor_run(const Scene& scene, const RunStatistics& statistics, const std::vector<Loss>& losses,
                      bool quiet);

}  // namespace sluice::app
