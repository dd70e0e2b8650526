// Studies whose points are runs: list them, run them, and make the tables of what is there.
#pragma once

#include "apps/sluice/options.hpp"
#include "studies/study.hpp"

namespace sluice::app {

using namespace study;

/// Runs a study of points, or what `options` ask for in its place. Returns the exit code: 1 when something
/// that is asserted did not come out, or a point could not be run.
int study_points(const Study& study, const StudyOptions& options);

}  // namespace sluice::app
