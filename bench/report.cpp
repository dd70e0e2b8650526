#include "bench/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bench/cases.hpp"
#include "bench/tables.hpp"
#include "core/solver/memory.hpp"
#include "core/text.hpp"
#include "cpu/backend.hpp"

namespace sluice::bench {
namespace {

constexpr std::array<uint32_t, 4> sizes = {1'000, 10'000, 100'000, 1'000'000};
constexpr std::array<Precision, 2> precisions = {Precision::single_, Precision::double_};
const std::array<std::string, 5> grid_parts = {"grid_count", "grid_scan", "grid_scatter", "grid_order",
                                               "reorder"};

/// What a WCSPH step is made of.
const std::vector<std::pair<std::string, std::vector<Stage>>> wcsph_parts = {
    {"search: grid, reorder, neighbours",
     {Stage::grid_count, Stage::grid_scan, Stage::grid_scatter, Stage::grid_order, Stage::reorder,
      Stage::neighbours}},
    {"density and kernel gradients: boundary, density, clamp_density",
     {Stage::boundary, Stage::density, Stage::clamp_density}},
    {"forces: external, xsph, tait, pressure_acceleration",
     {Stage::external, Stage::xsph, Stage::tait, Stage::pressure_acceleration}},
    {"integration and diagnostics: predict, integrate, diagnostics, totals",
     {Stage::predict, Stage::integrate, Stage::diagnostics, Stage::totals}}};

/// Throws when the parts leave out a stage of the step, or have one twice.
void require_all_stages(const std::vector<std::pair<std::string, std::vector<Stage>>>& parts) {
  std::vector<Stage> listed, planned;
  for (const auto& part : parts) listed.insert(listed.end(), part.second.begin(), part.second.end());
  for (const Stage stage : make_plan(model_of(make_scene({PressureMethod::wcsph}))).stages()) {
    if (!runs_once(stage)) planned.push_back(stage);
  }
  std::ranges::sort(listed);
  std::ranges::sort(planned);
  if (listed != planned) throw std::logic_error("the parts of a WCSPH step are not its stages");
}

std::string head(const std::string& title) {
  std::vector<std::string> names;
  for (const uint32_t size : sizes) names.push_back(size_text(size));
  return table_head(title, names);
}

/// One cell per size, with what `cell` says of 1 and of 2 threads.
template <class Cell>
std::string row_of(const std::string& title, Cell&& cell) {
  std::vector<std::string> cells;
  for (const uint32_t size : sizes)
    cells.push_back(number_text(cell(size, 1)) + " / " + number_text(cell(size, 2)));
  return table_row(title, cells);
}

}  // namespace

Collector::Collector() : ConsoleReporter(isatty(STDOUT_FILENO) == 1 ? OO_Color : OO_None) {}

void Collector::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.error_occurred) failed_ = true;
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    repetitions_ = std::max(repetitions_, static_cast<std::size_t>(run.repetitions));
    std::map<std::string, double> counters = {{"seconds", run.GetAdjustedRealTime() * 1e-6}};
    for (const auto& [name, counter] : run.counters) counters[name] = counter.value;
    auto& best = best_[run.run_name.function_name];
    if (best.empty() || counters["seconds"] < best["seconds"]) best = counters;
  }
}

double Collector::number(const std::string& name, const std::string& counter) const {
  const auto found = best_.find(name);
  if (found == best_.end() || !found->second.contains(counter))
    return std::numeric_limits<double>::quiet_NaN();
  return found->second.at(counter);
}

std::string Collector::wcsph_tables() const {
  const std::vector<uint32_t> compared = {peer_size, 100'000};
  const auto key = [](uint32_t size, int threads) {
    return CaseKey{PressureMethod::wcsph, size, Precision::single_, threads}.name();
  };
  const auto millions = [&](uint32_t size, int threads, const std::string& what) {
    return 1e-6 / number(key(size, threads) + "/" + what, "per_particle");
  };
  const auto share = [&](uint32_t size, int threads, const std::vector<Stage>& stages) {
    double sum = 0;
    for (const Stage stage : stages)
      sum += number(key(size, threads) + "/step", std::string(info(stage).name));
    return 100 * sum / number(key(size, threads) + "/step", "per_particle");
  };
  const auto row = [&](const std::string& title, auto&& cell) {
    std::vector<std::string> cells;
    for (const uint32_t size : compared)
      cells.push_back(number_text(cell(size, 1)) + " / " + number_text(cell(size, 2)));
    return table_row(title, cells);
  };
  std::vector<std::string> names;
  for (const uint32_t size : compared) names.push_back(size_text(size));

  std::string page = "\n### WCSPH in float, millions of particle-steps per second, 1 / 2 threads\n\n";
  page += table_head("", names);
  page += table_row("yardstick, 1 thread", {number_text(millions(compared[0], 1, "yardstick")),
                                            number_text(millions(compared[1], 1, "yardstick"))});
  page += table_row("SPlisHSPlasH 2.16 (quoted, see above)", {"1.8 / 3.3", "1.0 / 1.8"});
  page += row("Sluice", [&](uint32_t size, int threads) { return millions(size, threads, "step"); });
  page += row("Sluice, times the yardstick", [&](uint32_t size, int threads) {
    return millions(size, threads, "step") / millions(size, 1, "yardstick");
  });
  page += "\n### Where a WCSPH step goes, percent, 1 / 2 threads\n\n" + table_head("", names);
  require_all_stages(wcsph_parts);
  for (const auto& [title, stages] : wcsph_parts) {
    page += row(title, [&](uint32_t size, int threads) { return share(size, threads, stages); });
  }
  return page;
}

std::string Collector::markdown() const {
  using enum PressureMethod;
  const auto ns = [&](PressureMethod method, Precision precision, const std::string& what) {
    return [=, this](uint32_t size, int threads) {
      return 1e9 * number(CaseKey{method, size, precision, threads}.name() + "/" + what, "per_particle");
    };
  };
  const auto yardstick = [&](uint32_t size) { return ns(iisph, Precision::single_, "yardstick")(size, 1); };

  std::string page = fmt::format(
      "- processor: {}, {} hardware threads\n- compiler: {}, `{}`\n- copy bandwidth: {:.1f} GB/s with one "
      "thread, {:.1f} GB/s with two; reading 16 MB in the caches: {:.1f} and {:.1f} GB/s\n- the fastest of "
      "{} repetitions stands in the tables\n",
      cpu::processor_name(), cpu::hardware_threads(), SLUICE_BENCH_COMPILER, SLUICE_BENCH_FLAGS,
      number("copy/1", "bytes_per_second") * 1e-9, number("copy/2", "bytes_per_second") * 1e-9,
      number("read/1", "bytes_per_second") * 1e-9, number("read/2", "bytes_per_second") * 1e-9, repetitions_);
  page += others_text(watch_.others());
  for (const Precision precision : precisions) {
    page += fmt::format("- memory in {}: {:.0f} bytes per fluid particle\n", name_of(precision),
                        memory_need(make_scene({iisph, sizes[0], precision, 1}), precision).per_particle);
  }

  page += "\n### Sweeps, in millions of particles per second, 1 / 2 threads\n\n" + head("");
  page += "| yardstick, float, 1 thread |";
  for (const uint32_t size : sizes) page += fmt::format(" {} |", number_text(1e3 / yardstick(size)));
  page += '\n';
  for (const Precision precision : precisions) {
    const auto sweep = ns(iisph, precision, "sweep");
    const std::string name(name_of(precision));
    page += row_of(name, [&](uint32_t size, int threads) { return 1e3 / sweep(size, threads); });
    page += row_of(name + ", times the yardstick",
                   [&](uint32_t size, int threads) { return yardstick(size) / sweep(size, threads); });
  }

  page += fmt::format("\n### Whole steps per second (IISPH: {} sweeps), 1 / 2 threads\n\n", sweeps_per_step) +
          head("");
  for (const PressureMethod method : methods) {
    for (const Precision precision : precisions) {
      page += row_of(
          fmt::format("{}, {}", title_of(method), name_of(precision)), [&](uint32_t size, int threads) {
            return 1 / number(CaseKey{method, size, precision, threads}.name() + "/step", "seconds");
          });
    }
  }

  page += wcsph_tables();

  for (const Precision precision : precisions) {
    page +=
        fmt::format("\n### Stages in {}, nanoseconds per particle, 1 / 2 threads\n\n", name_of(precision));
    page += head("stage");
    for (const std::string& part : grid_parts) {
      page += row_of(part, [&](uint32_t size, int threads) {
        return number(CaseKey{iisph, size, precision, threads}.name() + "/grid", part + "_ns");
      });
    }
    for (uint32_t i = 0; i < stage_count; ++i) {
      const Stage stage = static_cast<Stage>(i);
      const std::string name(info(stage).name);
      const bool is_grid = std::find(grid_parts.begin(), grid_parts.end(), name) != grid_parts.end();
      if (is_grid || !info(stage).tasks.has(Task::step) || runs_once(stage)) continue;
      page += row_of(name, ns(timed_with(stage), precision, name));
    }
  }
  return page;
}

}  // namespace sluice::bench
