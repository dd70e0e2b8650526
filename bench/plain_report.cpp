// Which stages those are is not listed here: all of the plans that are timed.
#include "bench/plain_report.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <set>

#include "bench/benchmarks.hpp"
#include "bench/tables.hpp"
#include "core/text.hpp"

namespace sluice::bench {
namespace {

constexpr uint32_t size = 64'000;
constexpr std::array precisions = {Precision::single_, Precision::double_};
const std::set<Stage> grid = {Stage::grid_count, Stage::grid_scan, Stage::grid_scatter, Stage::grid_order,
                              Stage::reorder};

CaseKey key_of(PressureMethod method, Precision precision, int threads, bool plain) {
  CaseKey key{method, size, precision, threads};
  if (plain) key.instructions = cpu::Instructions::plain;
  return key;
}

/// "plain 1 / 2 threads", the same of the other, and their quotients, of nanoseconds(threads, plain).
template <class Nanoseconds>
std::string row(const std::string& title, const Nanoseconds& nanoseconds) {
  const auto both = [](double one, double two) { return number_text(one) + " / " + number_text(two); };
  return table_row(
      title,
      {both(nanoseconds(1, true), nanoseconds(2, true)), both(nanoseconds(1, false), nanoseconds(2, false)),
       both(nanoseconds(1, true) / nanoseconds(1, false), nanoseconds(2, true) / nanoseconds(2, false))});
}

}  // namespace

void add_plain_benchmarks() {
  const auto store = std::make_shared<CaseStore>();
  for (const PressureMethod method : methods) {
    for (const Precision precision : precisions) {
      for (const int threads : {1, 2}) {
        for (const bool plain : {true, false}) {
          const CaseKey key = key_of(method, precision, threads, plain);
          if (method == PressureMethod::iisph) add_sweep_benchmark(key, store);
          add_stage_benchmarks(key, store);
        }
      }
    }
  }
}

std::string plain_tables(const Collector& times) {
  const auto widest = std::string(name_of(cpu::widest_instructions()));
  std::string page;
  for (const Precision precision : precisions) {
    page += fmt::format("\n### Plain stages in {}, {} particles, nanoseconds per particle, 1 / 2 threads\n\n",
                        name_of(precision), size_text(size));
    page += table_head("stage", {"plain", widest, "plain / " + widest});
    const auto time = [&](PressureMethod method, const std::string& what, const std::string& counter,
                          double unit) {
      return [=, &times](int threads, bool plain) {
        return unit * times.number(key_of(method, precision, threads, plain).name() + "/" + what, counter);
      };
    };
    for (uint32_t i = 0; i < stage_count; ++i) {
      const Stage stage = static_cast<Stage>(i);
      if (stage == Stage::relax || runs_once(stage)) continue;
      const std::string name(info(stage).name);
      page += grid.contains(stage) ? row(name, time(PressureMethod::iisph, "grid", name + "_ns", 1))
                                   : row(name, time(timed_with(stage), name, "per_particle", 1e9));
    }
    page += row("a whole sweep", time(PressureMethod::iisph, "sweep", "per_particle", 1e9));
  }
  return page;
}

}  // namespace sluice::bench
