// Cells from results.
#include "studies/hard_table.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "studies/table.hpp"

namespace sluice::study {
namespace {

constexpr const char* as_expected = "as expected";

std::string number(double value, const char* format = "{:.3g}") {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "";
}

std::string dt_text(const RunStatistics& statistics) {
  if (statistics.steps() == 0) return "";
  const std::string least = number(statistics.dt_min()), largest = number(statistics.dt_max());
  return least == largest ? least : fmt::format("{} to {}", least, largest);
}

std::string outcome_text(const CaseResult& result) {
  if (!result.failure) return std::string(name_of(result.outcome));
  return fmt::format("stopped at step {}, t = {:.4g}, particle {} near ({:.4g}, {:.4g}): {}",
                     result.failure->step, result.failure->time, result.failure->id, result.failure->x.x,
                     result.failure->x.y, result.reason);
}

std::string verdict_text(const std::vector<std::string>& faults) {
  return faults.empty() ? as_expected : fmt::format("{}", fmt::join(faults, "; "));
}

/// Everything that a run measures, in the order of the columns.
std::vector<std::string> measured(const CaseResult& result) {
  const RunStatistics& all = result.statistics;
  const bool ran = all.steps() > 0;
  const auto if_ran = [&](const auto& text) { return ran ? fmt::format("{}", text) : std::string(); };
  std::vector<std::string> cells{dt_text(all), if_ran(all.steps()), number(result.time, "{:.6g}")};
  cells.insert(
      cells.end(),
      {if_ran(all.lost()), if_ran(number(all.cfl_max())), if_ran(number(all.iterations_mean())),
       if_ran(all.iterations_max()), if_ran(all.not_converged()), if_ran(all.repeats()),
       number(result.energy_drift, "{:.2g}"), number(result.energy_gain, "{:.2g}"),
       if_ran(number(all.compression_mean(), "{:.2g}")), if_ran(number(all.compression_max(), "{:.2g}")),
       number(result.kinetic_end), number(result.level_drift), number(result.rise), number(result.closest),
       if_ran(result.list_growths)});
  cells.push_back(result.end.x.empty() ? "" : fmt::format("{:016x}", digest(result.end)));
  return cells;
}

}  // namespace

const std::vector<std::string>& hard_columns() {
  static const std::vector<std::string> columns{
      "case",           "method",       "backend",      "warned",      "outcome",      "dt",
      "steps",          "time",         "lost",         "cfl_max",     "iterations",   "iterations_max",
      "unconverged",    "repeats",      "energy drift", "energy gain", "compression",  "max compression",
      "kinetic energy", "level drift",  "rise",         "closest",     "list growths", "state",
      "reason",         "failure_step", "failure_time", "failure_id",  "failure_x",    "failure_y",
      "expected",       "verdict"};
  return columns;
}

const std::vector<std::string>& hard_page_columns() {
  static const std::vector<std::string> columns{
      "case",    "method",     "backend",     "warned",       "dt",          "outcome",  "lost",
      "cfl_max", "iterations", "unconverged", "energy drift", "compression", "expected", "verdict"};
  return columns;
}

std::vector<std::string> hard_row(const HardCase& hard, const CaseResult& result) {
  std::vector<std::string> row{hard.name, hard.method, result.backend, result.warned ? "yes" : "no",
                               outcome_text(result)};
  const std::vector<std::string> numbers = measured(result);
  row.insert(row.end(), numbers.begin(), numbers.end());
  row.push_back(result.reason);
  if (const auto& failure = result.failure) {
    row.insert(row.end(), {fmt::format("{}", failure->step), number(failure->time, "{:.6g}"),
                           fmt::format("{}", failure->id), number(failure->x.x, "{:.6g}"),
                           number(failure->x.y, "{:.6g}")});
  } else {
    row.resize(row.size() + 5);
  }
  row.push_back(text_of(hard.expected));
  row.push_back(verdict_text(faults(hard, result)));
  return row;
}

std::vector<std::string> hard_row_without(const HardCase& hard, const std::string& backend,
                                          const std::string& how) {
  std::vector<std::string> row(hard_columns().size());
  row[place_of("case", hard_columns())] = hard.name;
  row[place_of("method", hard_columns())] = hard.method;
  row[place_of("backend", hard_columns())] = backend;
  row[place_of("outcome", hard_columns())] = how;
  row[place_of("expected", hard_columns())] = text_of(hard.expected);
  row[place_of("verdict", hard_columns())] = how;
  return row;
}

bool is_as_expected(const std::vector<std::string>& row) { return row.back() == as_expected; }

uint64_t digest(const Snapshot& state) {
  uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, half a number at a time
  const auto add = [&](double value) {
    const auto bits = std::bit_cast<uint64_t>(value);
    for (const uint64_t half : {bits >> 32, bits & 0xffffffff}) hash = (hash ^ half) * 0x100000001b3;
  };
  for (size_t i = 0; i < state.x.size(); ++i) {
    for (const double value :
         {state.x[i].x, state.x[i].y, state.v[i].x, state.v[i].y, state.density[i], state.pressure[i]})
      add(value);
  }
  return hash;
}

}  // namespace sluice::study
