// One benchmark per stage of the plan, each run again and again on the input it has in the middle of a run.
// Stages whose input is their own output do the same work nevertheless: p and a_n only change in value, and
// the five stages of the grid run as the group they are.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/benchmarks.hpp"
#include "bench/measure.hpp"

namespace sluice::bench {
namespace {

const std::vector<Stage> grid = {Stage::grid_count, Stage::grid_scan, Stage::grid_scatter, Stage::grid_order,
                                 Stage::reorder};

void time_stage(benchmark::State& state, Case& subject, Stage stage) {
  subject.preserving({stage}, [&] {
    for (auto _ : state) subject.backend().run(stage);
  });
  count_particles(state, subject.n());
}

void time_grid(benchmark::State& state, Case& subject) {
  subject.preserving(grid, [&] {
    subject.backend().reset_seconds();
    for (auto _ : state) subject.run(grid);
  });
  count_particles(state, subject.n());
  for (const Stage stage : grid) {
    state.counters[std::string(info(stage).name) + "_ns"] =
        1e9 * subject.backend().seconds(stage) / (static_cast<double>(state.iterations()) * subject.n());
  }
}

}  // namespace

void add_stage_benchmarks(const CaseKey& key, const std::shared_ptr<CaseStore>& store) {
  const Plan plan = make_plan(model_of(make_scene(key)));
  const bool iisph = key.method == PressureMethod::iisph;
  if (iisph) {
    add(key, "grid", [=](benchmark::State& state) { time_grid(state, store->frozen(key)); });
  }
  std::vector<Stage> added = grid;
  for (const Stage stage : plan.stages()) {
    if (std::find(added.begin(), added.end(), stage) != added.end()) continue;
    added.push_back(stage);
    if (timed_with(stage) != key.method || runs_once(stage)) continue;
    add(key, std::string(info(stage).name),
        [=](benchmark::State& state) { time_stage(state, store->frozen(key), stage); });
  }
}

}  // namespace sluice::bench
