// From runs to limits, and from limits to what the thesis says of them.
#pragma once

#include <vector>

#include "studies/study.hpp"

namespace sluice {

/// Adds the table of limits and the page.
void add_timestep_limits(const std::vector<Result>& results, Report& report);

}  // namespace sluice
