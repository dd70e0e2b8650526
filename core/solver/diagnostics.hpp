// What one step reports, from the totals that its last stage wrote.
#pragma once

#include <span>

#include "core/model/params.hpp"
#include "sluice/report.hpp"

namespace sluice {

/// `totals` as written by the stage of that name.
Diagnostics make_diagnostics(std::span<const double> totals, const Params& params);

}  // namespace sluice
