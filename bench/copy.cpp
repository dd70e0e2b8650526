// Copy bandwidth of the machine, measured in the same run as what it limits.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/benchmarks.hpp"

namespace sluice::bench {
namespace {

constexpr int64_t values = 32 * 1024 * 1024;  // 256 MB in each array

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

}  // namespace

void add_copy_benchmark(int threads) {
  benchmark::RegisterBenchmark(fmt::format("copy/{}", threads).c_str(),
                               [=](benchmark::State& state) { time_copy(state, threads); })
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace sluice::bench
