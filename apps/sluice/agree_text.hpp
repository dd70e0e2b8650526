// What the ways of comparing backends have in common: names of stages, tolerances, the table.
#pragma once

#include <string>
#include <vector>

#include "core/agree/agree.hpp"
#include "core/model/plan.hpp"
#include "gpu/context.hpp"

namespace sluice::app {

/// Stage of the plan with this name. Throws InputError, which names `option` and the stages there are.
Stage stage_named(const std::string& option, const std::string& name, const Plan& plan);

/// Tolerance of a stage, in units in the last place of a field's largest value: none where the processor
/// draws; some on a graphics card, whose divisions and roots are not exactly rounded, and where sums of a
/// dozen such terms cancel in part.
double tolerance_on(const gpu::Context& context);
std::string tolerance_text(double tolerance);

/// Table for people, with a row per stage and its first difference.
std::string table_of(const std::vector<StageAgreement>& stages);

}  // namespace sluice::app
