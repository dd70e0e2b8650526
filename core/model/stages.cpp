// The rows of the stage table as values.
#include "core/model/stages.hpp"

#include <algorithm>

namespace sluice {
namespace {

// Names in the rows' lists are those of each list's own enum.
#define PHASES(...)               \
  ([] {                           \
    using enum Phase;             \
    return PhaseSet{__VA_ARGS__}; \
  }())
#define FIELDS(...)               \
  ([] {                           \
    using enum Field;             \
    return FieldSet{__VA_ARGS__}; \
  }())
#define TASKS(...)               \
  ([] {                          \
    using enum Task;             \
    return TaskSet{__VA_ARGS__}; \
  }())
#define STAGE(name, phases, reads, writes, range, need, tasks, equation) \
  StageInfo{#name,         PHASES phases, FIELDS reads, FIELDS writes,   \
            Length::range, &Needs::need,  TASKS tasks,  equation},
constexpr std::array<StageInfo, stage_count> table{{SLUICE_STAGES(STAGE)}};
static_assert(std::ranges::none_of(table, &std::string_view::empty, &StageInfo::equation));
static_assert(std::ranges::none_of(field_table, &std::string_view::empty, &FieldInfo::unit));
static_assert(std::ranges::none_of(field_table, &std::string_view::empty, &FieldInfo::meaning));
static_assert(std::ranges::none_of(need_table, &std::string_view::empty, &NeedInfo::meaning));
#undef STAGE
#undef TASKS
#undef FIELDS
#undef PHASES

FieldSet existing(FieldSet set, const Needs& needs) {
  FieldSet kept;
  for (uint32_t i = 0; i < field_count; ++i) {
    const Field field = static_cast<Field>(i);
    if (set.has(field) && needs.*info(field).need) kept = kept | FieldSet{field};
  }
  return kept;
}

}  // namespace

const std::array<StageInfo, stage_count>& stage_table() { return table; }

const StageInfo& info(Stage stage) { return table[static_cast<uint32_t>(stage)]; }

bool runs_once(Stage stage) {
  for (const PhaseInfo& row : phase_table) {
    if (row.runs != Runs::once && info(stage).phases.has(row.phase)) return false;
  }
  return true;
}

FieldSet reads_of(Stage stage, const Needs& needs) { return existing(info(stage).reads, needs); }
FieldSet writes_of(Stage stage, const Needs& needs) { return existing(info(stage).writes, needs); }

}  // namespace sluice
