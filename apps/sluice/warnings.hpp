// What a user should know of a run that is valid and yet may not be worth much.
#pragma once

#include <string>

#include "apps/sluice/options.hpp"
#include "core/output/summary.hpp"
#include "core/scene/scene.hpp"
#include "core/solver/limits.hpp"

namespace sluice::app {

/// One line on standard error, unless `quiet`.
void warn(bool quiet, const std::string& message);

/// Options for OpenGL in a run that neither computes nor draws with it.
void warn_of_unused_opengl(const MachineOptions& options, bool quiet);

/// Why a run became invalid, where, and what often helps.
std::string failure_text(const Scene& scene, const RunStatistics& statistics, const Failure& failure);

/// Which particles left the domain, when and where, if any did.
void warn_of_losses(const RunStatistics& statistics, const std::vector<Loss>& losses, bool quiet);

/// Steps that did not converge, particles that moved too far or were lost, and where, a fluid that gives way.
void warn_of_poor_run(const Scene& scene, const RunStatistics& statistics, const std::vector<Loss>& losses,
                      bool quiet);

}  // namespace sluice::app
