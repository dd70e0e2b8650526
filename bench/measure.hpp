// How every benchmark is registered and what it counts.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "bench/cases.hpp"

namespace sluice::bench {

/// Registers `f` as KEY/what, timed by the wall clock.
template <class F>
benchmark::internal::Benchmark* add(const CaseKey& key, const std::string& what, F&& f) {
  return benchmark::RegisterBenchmark((key.name() + "/" + what).c_str(), std::forward<F>(f))
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
}

/// Particles per second, and seconds per particle in the counter "per_particle".
inline void count_particles(benchmark::State& state, uint32_t n) {
  using benchmark::Counter;
  state.SetItemsProcessed(state.iterations() * n);
  state.counters["per_particle"] =
      Counter(n, static_cast<Counter::Flags>(Counter::kIsIterationInvariantRate | Counter::kInvert));
}

}  // namespace sluice::bench
