// Walks over sizes, and says on standard error where it is.
#include "bench/gpu_report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>

#include "bench/gpu_page.hpp"
#include "core/stopwatch.hpp"
#include "cpu/backend.hpp"
#include "gpu/context.hpp"
#include "gpu/copy.hpp"
#include "sluice/error.hpp"
#include "sluice/version.hpp"

namespace sluice::bench {
namespace {

constexpr std::array<uint32_t, 4> sizes = {10'000, 100'000, 1'000'000, 10'000'000};
constexpr uint32_t largest_on_software = 1'000'000, size_beside_cpu = 100'000;
/// The first is breaking_dam at a spacing of 0.8.
constexpr std::array<uint32_t, 2> compared_sizes = {74'100, size_beside_cpu};
constexpr std::array<uint32_t, 8> small_sizes = {1'000,  2'500,  5'000,   10'000,
                                                 20'000, 50'000, 100'000, 250'000};
constexpr uint64_t copied_bytes = 256 * 1024 * 1024;

StepTimes times_of(const CaseKey& key, const gpu::Context* context) {
  fmt::print(stderr, "sluice_bench: {}\n", key.name());
  Case subject(key, context);
  return time_steps(subject);
}

SizeTimes size_times(uint32_t size, const gpu::Context& context) {
  SizeTimes times{size, {}, ""};
  if (context.software() && size > largest_on_software) {
    times.left_out = "it would take too long where a processor plays the graphics card";
    return times;
  }
  try {
    for (const PressureMethod method : methods)
      times.steps[method] = times_of({method, size, Precision::single_, 1, Machine::gpu}, &context);
  } catch (const EnvironmentError& error) {
    times.left_out = error.what();
    times.steps.clear();
  }
  return times;
}

SizeTimes cpu_times() {
  SizeTimes times{size_beside_cpu, {}, ""};
  for (const PressureMethod method : methods) {
    times.steps[method] =
        times_of({method, size_beside_cpu, Precision::single_, cpu::hardware_threads()}, nullptr);
  }
  return times;
}

GpuReport measure(const gpu::Context& context) {
  const Stopwatch watch;
  GpuReport report;
  report.renderer = context.renderer();
  report.driver = context.version();
  report.software = context.software();
  report.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
  report.processor = cpu::processor_name();
  report.threads = cpu::hardware_threads();
  report.compiler = fmt::format("{}, `{}`", SLUICE_BENCH_COMPILER, SLUICE_BENCH_FLAGS);
  report.bytes = static_cast<double>(copied_bytes);
  report.copy = 2 * report.bytes / gpu::copy_seconds(context, copied_bytes, 20);
  for (const uint32_t size : compared_sizes) {
    fmt::print(stderr, "sluice_bench: sweeps of {} beside the CPU\n", size_text(size));
    report.compared.push_back(compare_sweeps(size, context));
  }
  for (const uint32_t size : small_sizes) {
    fmt::print(stderr, "sluice_bench: steps of {} beside the CPU\n", size_text(size));
    report.small.push_back(compare_steps(size, context));
  }
  report.cpu = cpu_times();
  for (const uint32_t size : sizes) report.sizes.push_back(size_times(size, context));
  report.others = watch.others();
  return report;
}

}  // namespace

bool report_gpu(const GpuOptions& options) {
  const gpu::Context context;
  GpuReport report = measure(context);
  if (options.test_log) report.tests = read_test_log(*options.test_log);
  if (!options.agreement.empty()) report.agreement = read_agreement(options.agreement);
  const std::string page = gpu_page(report);
  if (options.pages) {
    const std::filesystem::path path = *options.pages / page_name(report.renderer);
    std::ofstream file(path);
    file << page;
    if (!file.flush()) throw Error(fmt::format("cannot write {}", path.string()));
    fmt::print(stderr, "sluice_bench: wrote {}\n", path.string());
  } else {
    fmt::print("{}", page);
  }
  return (!report.tests || report.tests->good) && (!report.agreement || report.agreement->good);
}

}  // namespace sluice::bench
