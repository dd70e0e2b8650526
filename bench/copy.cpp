// Bandwidths of the machine, measured in the same run as what they limit: copying in memory, and reading from
// the last-level cache.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/benchmarks.hpp"

namespace sluice::bench {
namespace {

constexpr int64_t values = 32 * 1024 * 1024;  // 256 MB in each array
constexpr int64_t cached = 4 * 1024 * 1024;   // 16 MB, about the lists of 100,000 particles

/// Counts what is read and what is written, as STREAM does.
void time_copy(benchmark::State& state, int threads) {
  std::vector<double> from(values), to(values);
  const double* a = from.data();
  double* b = to.data();
  for (auto _ : state) {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int64_t i = 0; i < values; ++i) b[i] = a[i];
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * 2 * values * static_cast<int64_t>(sizeof(double)));
}

/// Reads the same array again and again.
void time_read(benchmark::State& state, int threads) {
  const std::vector<uint32_t> from(cached, 1);
  for (auto _ : state) {
    uint32_t sum = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : sum)
    for (int64_t i = 0; i < cached; ++i) sum += from[static_cast<size_t>(i)];
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(state.iterations() * cached * static_cast<int64_t>(sizeof(uint32_t)));
}

}  // namespace

void add_bandwidth_benchmarks(int threads) {
  benchmark::RegisterBenchmark(fmt::format("read/{}", threads).c_str(),
                               [=](benchmark::State& state) { time_read(state, threads); })
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);

  benchmark::RegisterBenchmark(fmt::format("copy/{}", threads).c_str(),
                               [=](benchmark::State& state) { time_copy(state, threads); })
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace sluice::bench
