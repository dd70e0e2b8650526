// Puts the needed stages into their phases, in the order of the table.
#include "core/model/plan.hpp"

namespace sluice {

Plan make_plan(const Model& model, Task task) {
  Plan plan;
  plan.needs = needs_of(task == Task::relaxation ? model.relaxing() : model);
  for (uint32_t s = 0; s < stage_count; ++s) {
    const Stage stage = static_cast<Stage>(s);
    const StageInfo& row = info(stage);
    if (!row.tasks.has(task) || !(plan.needs.*row.need)) continue;
    for (const PhaseInfo& phase : phase_table) {
      if (row.phases.has(phase.phase) && plan.needs.*phase.need)
        plan.phases[static_cast<uint32_t>(phase.phase)].push_back(stage);
    }
  }
  return plan;
}

FieldSet Plan::fields() const {
  FieldSet all;
  for (const auto& [left, found] : handed_on) all = all | FieldSet{left, found};
  for (const Stage stage : stages()) all = all | reads_of(stage, needs) | writes_of(stage, needs);
  return all;
}

std::vector<Stage> Plan::stages() const {
  std::vector<Stage> all;
  for (const auto& phase : phases) all.insert(all.end(), phase.begin(), phase.end());
  return all;
}

}  // namespace sluice
