// From runs to limits, and from limits to what the thesis says of them.
#pragma once

#include <filesystem>
#include <vector>

#include "studies/study.hpp"
#include "studies/verdicts.hpp"

namespace sluice::study {

/// Adds the table of limits and the page.
void add_timestep_limits(const std::vector<Result>& results, Report& report);

/// Whether the result is of the grid of time steps, not one of the whole runs that are looked at in the end.
bool is_trial(const Result& result);

/// Mean over the last 10 frames of the kinetic energy of those particles that are not lost then. What is lost
/// falls ever faster.
double kinetic_energy_at_end(const std::filesystem::path& recording);

/// Whether only SSPH falls apart without viscosity.
void judge_coherence(const std::vector<Result>& results, Verdicts& verdicts);

}  // namespace sluice::study
