// sluice_bench [--million] [--markdown FILE] [Google Benchmark's options]
// Times every stage, sweeps and whole steps on the CPU. --million adds a million particles (minutes more),
// --markdown writes the tables of docs/results/cpu.md.
//
// sluice_bench --plain FILE [Google Benchmark's options]
// Times every plain stage of the CPU beside the one for the widest instructions, and writes a table of that.
//
// sluice_bench --gpu [--pages FOLDER] [--tests LOG] [--agreement FILE]...
// Times the same on the GPU, with whatever sizes it holds, and writes FOLDER/<name of the GPU>.md or prints
// it, with the result of the tests in ctest's LOG and of each `sluice agree --summary FILE`. Exit code 1 when
// one of these is bad.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <string_view>

#include "bench/benchmarks.hpp"
#include "bench/gpu_report.hpp"
#include "bench/plain_report.hpp"
#include "bench/report.hpp"

namespace sluice::bench {
namespace {

struct Options {
  bool million = false;
  std::string markdown, plain;
  bool on_gpu = false;
  GpuOptions gpu;
  std::vector<char*> rest;  ///< for Google Benchmark
};

Options parse(int argc, char** argv) {
  static char min_time[] = "--benchmark_min_time=0.05";
  Options options;
  options.rest = {argv[0], min_time};  // before the user's, which win
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--million")
      options.million = true;
    else if (word == "--gpu")
      options.on_gpu = true;
    else if (word == "--markdown" && has_value)
      options.markdown = argv[++i];
    else if (word == "--plain" && has_value)
      options.plain = argv[++i];
    else if (word == "--pages" && has_value)
      options.gpu.pages = argv[++i];
    else if (word == "--tests" && has_value)
      options.gpu.test_log = argv[++i];
    else if (word == "--agreement" && has_value)
      options.gpu.agreement.push_back(argv[++i]);
    else
      options.rest.push_back(argv[i]);
  }
  return options;
}

void add_benchmarks(bool million) {
  for (const int threads : {1, 2}) add_bandwidth_benchmarks(threads);
  const auto store = std::make_shared<CaseStore>();
  std::vector<uint32_t> sizes = {1'000, 10'000, 100'000};
  if (million) sizes.push_back(1'000'000);
  for (const int threads : {1, 2})
    add_step_benchmarks({PressureMethod::wcsph, peer_size, Precision::single_, threads}, store);
  for (const uint32_t size : sizes) {
    for (const PressureMethod method : methods) {
      for (const Precision precision : {Precision::single_, Precision::double_}) {
        for (const int threads : {1, 2}) {
          const CaseKey key{method, size, precision, threads};
          add_step_benchmarks(key, store);
          add_stage_benchmarks(key, store);
        }
      }
    }
  }
}

/// Returns an exit code.
int write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (file.flush()) return 0;
  fmt::print(stderr, "sluice_bench: cannot write {}\n", path);
  return 1;
}

int run(int argc, char** argv) {
  Options options = parse(argc, argv);
  int rest = static_cast<int>(options.rest.size());
  benchmark::Initialize(&rest, options.rest.data());
  if (benchmark::ReportUnrecognizedArguments(rest, options.rest.data())) return 2;
  if (options.on_gpu) return report_gpu(options.gpu) ? 0 : 1;
  if (options.plain.empty())
    add_benchmarks(options.million);
  else
    add_plain_benchmarks();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::Shutdown();
  if (collector.failed()) {
    fmt::print(stderr, "sluice_bench: a benchmark failed, see above\n");
    return 1;
  }
  if (!options.plain.empty()) return write(options.plain, plain_tables(collector));
  return options.markdown.empty() ? 0 : write(options.markdown, collector.markdown());
}

}  // namespace
}  // namespace sluice::bench

int main(int argc, char** argv) {
  try {
    return sluice::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "sluice_bench: {}\n", error.what());
    return 1;
  }
}
