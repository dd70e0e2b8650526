// Words and numbers of comparisons.
#include "apps/sluice/agree_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sluice/error.hpp"

namespace sluice::app {
namespace {

std::string value_text(const Difference::Place& place, double value) {
  return is_integer(place.field) ? fmt::format("{:.0f}", value) : fmt::format("{:.9g}", value);
}

std::string first_text(const Difference& difference) {
  if (difference.all_zero) return "(all zero)";
  if (!difference.first) return "";
  const auto& place = *difference.first;
  return fmt::format("{}[{}]: {} and {}", info(place.field).name, place.index,
                     value_text(place, place.reference), value_text(place, place.other));
}

/// Text that says when a stage of this name runs; empty when there is none.
std::string when_it_runs(std::string_view name) {
  const auto stage = std::ranges::find(stage_table(), name, &StageInfo::name);
  if (stage == stage_table().end()) return "";
  if (!stage->tasks.has(Task::step)) return ", which runs while a start is relaxed only";
  return fmt::format(", which is for: {}",
                     std::ranges::find(need_table, stage->need, &NeedInfo::need)->meaning);
}

}  // namespace

Stage stage_named(const std::string& option, const std::string& name, const Plan& plan) {
  std::string known;
  std::set<Stage> seen;
  for (const Stage stage : plan.stages()) {
    if (info(stage).name == name) return stage;
    if (seen.insert(stage).second) known += fmt::format(" {}", info(stage).name);
  }
  throw InputError(fmt::format("{}: found \"{}\"{}, expected a stage of this scene's plan:{}", option, name,
                               when_it_runs(name), known));
}

double tolerance_on(const gpu::Context& context) { return context.software() ? 0 : hardware_tolerance; }

std::string tolerance_text(double tolerance) {
  return tolerance > 0 ? fmt::format("{:g} ulp of a field's largest value per stage", tolerance)
                       : "none, every bit counts";
}

std::string table_of(const std::vector<StageAgreement>& stages) {
  std::string text = fmt::format("{:<24}{:>12}{:>12}{:>10}  {:<5} {}\n", "stage, same input", "largest diff",
                                 "in ulp", "equal", "", "first difference: CPU and GPU");
  for (const StageAgreement& row : stages) {
    text += fmt::format("{:<24}{:>12.3g}{:>12.3g}{:>9.4g}%  {:<5} {}\n", info(row.stage).name,
                        row.difference.max_abs, row.difference.max_ulp, 100 * row.difference.equal_share(),
                        row.pass ? "ok" : "FAIL", first_text(row.difference));
  }
  return text;
}

}  // namespace sluice::app
