// `sluice study hard`: the hard cases on both backends.
#pragma once

#include "apps/sluice/options.hpp"

namespace sluice::app {

/// Writes scenes/NAME.toml of every case and the tables hard.csv and hard.md into the folder of `options`.
/// Returns 1 when a case did not come out as expected, else 0. Throws EnvironmentError without OpenGL.
int study_hard(const StudyOptions& options);

}  // namespace sluice::app
