// The table, and the arithmetic of groups.
#include "gpu/passes.hpp"

#include <algorithm>

namespace sluice::gpu {
namespace {

/// What a pass runs over: the range of the stage's row, particles, cells, slices of the neighbour list, runs
/// of cells by one invocation each or all by one group, or level by level a tree of sums per chunk.
enum class Over { range, particles, cells, slices, runs_of_cells, all_runs_by_one_group, tree };

struct Row {
  Stage stage;
  std::vector<Over> passes = {Over::range};
  uint32_t tree_arrays = 0, tree_results = 0;  ///< of a tree: how many, and invocations of its last level
  uint64_t (*scratch)(const Sizes&, const Row&) = nullptr;
  bool ends_sweeps = false;     ///< writes the numbers of groups that later stages of a sweep have
  bool once_after_end = false;  ///< has groups in the sweep that ends a solve
};

uint64_t groups_of(uint64_t count, uint64_t per_group) { return (count + per_group - 1) / per_group; }

uint64_t per_particle(const Sizes& sizes, const Row&) { return sizes.fluid; }
uint64_t per_run(const Sizes& sizes, const Row&) { return groups_of(sizes.of(Length::cells), scan_width); }
uint64_t one_number(const Sizes&, const Row&) { return 1; }
/// Two halves, used in turns by the levels of a tree.
uint64_t two_levels(const Sizes& sizes, const Row& row) {
  return 2 * row.tree_arrays * groups_of(sizes.chunks(), chunk_width);
}

const std::vector<Row>& table() {
  using enum Over;
  static const std::vector<Row> rows{
      {.stage = Stage::grid_count, .passes = {cells, particles}},
      {.stage = Stage::grid_scan,
       .passes = {runs_of_cells, all_runs_by_one_group, runs_of_cells},
       .scratch = per_run},
      {.stage = Stage::grid_order, .passes = {particles, particles}, .scratch = per_particle},
      {.stage = Stage::neighbours, .passes = {particles, slices, particles}, .scratch = one_number},
      {.stage = Stage::stop_test,
       .passes = {tree},
       .tree_arrays = residual_sum_count,
       .tree_results = 1,
       .scratch = two_levels,
       .ends_sweeps = true},
      {.stage = Stage::pressure_update, .once_after_end = true},
      {.stage = Stage::totals,
       .passes = {tree},
       .tree_arrays = total_count,
       .tree_results = total_count,
       .scratch = two_levels},
  };
  return rows;
}

/// The stage's row, or that of all stages without one. No copy: sweeps ask for it.
const Row& row_of(Stage stage) {
  static const Row others{.stage = Stage::count};
  const auto row = std::ranges::find(table(), stage, &Row::stage);
  return row == table().end() ? others : *row;
}

Pass each_invocation(uint32_t number, uint64_t count, uint32_t group_size) {
  Pass pass;
  pass.number = number;
  pass.count = count;
  pass.per_group = group_size;
  return pass;
}

Pass one_group(uint32_t number, uint64_t count) {
  Pass pass = each_invocation(number, count, 0);
  pass.entry = Entry::group;
  pass.per_group = count;
  return pass;
}

/// Folds of sums per chunk, level by level: PASS 0 all but the last level, which is PASS 1.
std::vector<Pass> tree_passes(const Row& row, const Sizes& sizes, uint32_t group_size) {
  std::vector<Pass> passes;
  uint64_t length = sizes.chunks(), from = 0, to = 0;
  const uint64_t half = two_levels(sizes, row) / 2;
  const auto add = [&](Pass pass) {
    pass.fold_length = static_cast<uint32_t>(length);
    pass.fold_from = static_cast<uint32_t>(from);
    pass.fold_to = static_cast<uint32_t>(to);
    pass.fold_first = passes.empty();
    passes.push_back(pass);
  };
  while (length > chunk_width) {
    const uint64_t groups = groups_of(length, chunk_width);
    add(each_invocation(0, row.tree_arrays * groups, group_size));
    length = groups;
    from = to;
    to = half - to;
  }
  add(each_invocation(1, row.tree_results, group_size));
  return passes;
}

uint64_t count_of(Over over, Stage stage, const Sizes& sizes) {
  switch (over) {
    case Over::particles: return sizes.fluid;
    case Over::cells: return sizes.of(Length::cells);
    case Over::slices: return groups_of(sizes.fluid, slice_width);
    case Over::runs_of_cells:
    case Over::all_runs_by_one_group: return groups_of(sizes.of(Length::cells), scan_width);
    case Over::range:
    case Over::tree: break;
  }
  return sizes.of(info(stage).range);
}

}  // namespace

std::vector<Pass> passes_of(Stage stage, const Sizes& sizes, uint32_t group_size) {
  const Row& row = row_of(stage);
  std::vector<Pass> passes;
  for (const Over over : row.passes) {
    if (over == Over::tree) return tree_passes(row, sizes, group_size);
    const auto number = static_cast<uint32_t>(passes.size());
    const uint64_t count = count_of(over, stage, sizes);
    passes.push_back(over == Over::all_runs_by_one_group ? one_group(number, count)
                                                         : each_invocation(number, count, group_size));
  }
  return passes;
}

bool has_scratch(Stage stage) { return row_of(stage).scratch != nullptr; }
bool ends_sweeps(Stage stage) { return row_of(stage).ends_sweeps; }

uint64_t scratch_size(const Sizes& sizes) {
  uint64_t size = 1;
  for (const Row& row : table()) {
    if (row.scratch != nullptr) size = std::max(size, row.scratch(sizes, row));
  }
  return size;
}

uint64_t most_cells(uint32_t group_size) {
  const uint64_t runs_per_invocation = (most_rounds - group_size) / 2;  // it walks over them twice
  return runs_per_invocation * group_size * scan_width - 1;
}

PassConstants constants_of(const Pass& pass, const Sizes& sizes) {
  return {.count = static_cast<uint32_t>(pass.count),
          .cells = static_cast<uint32_t>(sizes.of(info(Field::C).length)),
          .list_size = static_cast<uint32_t>(sizes.list),
          .fold_length = pass.fold_length,
          .fold_from = pass.fold_from,
          .fold_to = pass.fold_to,
          .fold_first = pass.fold_first ? 1u : 0u};
}

SweepGroups sweep_groups_of(Stage stage) {
  if (row_of(stage).once_after_end) return SweepGroups::update;
  if (row_of(stage).ends_sweeps) return SweepGroups::test;
  return info(stage).range == Length::chunks ? SweepGroups::chunks : SweepGroups::particles;
}

}  // namespace sluice::gpu
