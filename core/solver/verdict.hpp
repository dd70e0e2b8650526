// Whether the state a step led to is valid, and if it is not, which particle shows it first and why.
#pragma once

#include <optional>

#include "core/model/params.hpp"
#include "sluice/report.hpp"

namespace sluice {

/// Whether the totals of a step call for a look at every particle: something is not finite, a particle
/// crossed more than 100 spacings, or more than a tenth of the fluid is lost.
bool is_suspect(const StepReport& report, const Params& params);

/// Whether every position, velocity, density and pressure is finite.
bool is_finite(const Snapshot& snapshot);

/// The reason why a suspect step is invalid. `before` is the state it started from, for the last finite
/// position.
Failure find_failure(const StepReport& report, const Params& params, const Snapshot& before,
                     const Snapshot& after);

/// The reason why an adaptive step is invalid that moved a particle further than `cfl` spacings though no
/// shorter one is allowed.
Failure find_runaway(const StepReport& report, const Params& params, double cfl, const Snapshot& after);

/// The reason why a step can't be made of a state in which too many particles stand in one place.
Failure find_crowd(const StepReport& report, const Params& params, const Snapshot& before);

}  // namespace sluice
