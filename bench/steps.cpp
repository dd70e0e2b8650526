// Whole steps, sweeps, and the yardstick beside them.
#include <fmt/format.h>

#include <array>

#include "bench/benchmarks.hpp"
#include "bench/measure.hpp"
#include "bench/wcsph_yardstick.hpp"
#include "bench/yardstick.hpp"

namespace sluice::bench {
namespace {

constexpr double yardstick_tolerance = 1e-4;

/// Also counts, per particle, what each stage took.
void time_step(benchmark::State& state, Case& subject) {
  subject.backend().reset_seconds();
  for (auto _ : state) subject.step();
  count_particles(state, subject.n());
  const double steps = static_cast<double>(state.iterations()) * subject.n();
  for (const Stage stage : subject.plan().stages())
    state.counters[std::string(info(stage).name)] = subject.backend().seconds(stage) / steps;
}

void time_sweep(benchmark::State& state, Case& subject) {
  const std::vector<Stage>& sweep = subject.plan()[Phase::sweep];
  subject.preserving(sweep, [&] {
    for (auto _ : state) {
      subject.start_solve();
      subject.backend().sweep(sweep, 1);
    }
  });
  count_particles(state, subject.n());
}

/// Refuses to time a yardstick that computes something else than the backend.
void time_yardstick(benchmark::State& state, Case& subject) {
  Yardstick yardstick(subject.backend(), subject.params(), subject.samples());
  const std::vector<Stage>& sweep = subject.plan()[Phase::sweep];
  subject.preserving(sweep, [&] {
    subject.start_solve();
    subject.run(sweep);
    yardstick.sweep();
    const double difference = yardstick.difference(subject.backend());
    if (!(difference <= yardstick_tolerance)) {
      state.SkipWithError(
          fmt::format("the yardstick's pressures differ from the backend's by {:.2g}", difference).c_str());
    }
  });
  for (auto _ : state) benchmark::DoNotOptimize(yardstick.sweep());
  count_particles(state, subject.n());
}

void time_wcsph_yardstick(benchmark::State& state, Case& subject) {
  WcsphYardstick yardstick(subject.backend(), subject.params(), subject.samples());
  subject.step();
  yardstick.step();
  const double difference = yardstick.difference(subject.backend());
  if (!(difference <= yardstick_tolerance)) {
    state.SkipWithError(
        fmt::format("the yardstick's velocities differ from the backend's by {:.2g}", difference).c_str());
  }
  for (auto _ : state) yardstick.step();
  count_particles(state, subject.n());
}

}  // namespace

void add_sweep_benchmark(const CaseKey& key, const std::shared_ptr<CaseStore>& store) {
  add(key, "sweep", [=](benchmark::State& state) { time_sweep(state, store->frozen(key)); });
}

void add_step_benchmarks(const CaseKey& key, const std::shared_ptr<CaseStore>& store) {
  // A fixed number: a step moves the fluid on, so that more of them are not the same ones again.
  add(key, "step", [=](benchmark::State& state) {
    time_step(state, store->stepping(key));
  })->Iterations(key.size <= 10'000 ? 50 : 4);
  const bool is_plain = key.threads == 1 && key.precision == Precision::single_;
  if (key.method == PressureMethod::wcsph && is_plain) {
    add(key, "yardstick", [=](benchmark::State& state) {
      time_wcsph_yardstick(state, store->stepping(key));
    })->Iterations(key.size <= 10'000 ? 50 : 4);
  }
  if (key.method != PressureMethod::iisph) return;
  add_sweep_benchmark(key, store);
  if (is_plain) {
    add(key, "yardstick", [=](benchmark::State& state) { time_yardstick(state, store->frozen(key)); });
  }
}

}  // namespace sluice::bench
