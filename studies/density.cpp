// Amplitude of the mean density per window of time.
#include "studies/density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/settings.hpp"
#include "studies/verdicts.hpp"

namespace sluice::study {
namespace {

constexpr double window = 20, duration = 100;

Point run(const std::string& name, const std::string& figure, const std::string& method,
          std::vector<std::string> overrides) {
  Point point{.name = name, .scene = "resting_fluid", .overrides = std::move(overrides)};
  point.series = point.quick = true;
  point.facts = {{"figure", figure}, {"run", method}};
  return point;
}

Point ssph(const std::string& figure, const std::string& k, const std::string& dt) {
  return run(fmt::format("ssph_k_{}", k), figure, fmt::format("SSPH, k = {}", k),
             {"pressure.method=ssph", "pressure.ssph.stiffness=" + k, "time.dt=" + dt});
}

struct Window {
  double from = 0, least = 0, most = 0, sum = 0, squares = 0;
  int steps = 0;

  double mean() const { return sum / steps; }
  /// Root of two standard deviations: the amplitude of a sine.
  double amplitude() const { return std::sqrt(2 * std::max(0.0, squares / steps - mean() * mean())); }
  double largest() const { return (most - least) / 2; }
};

/// Of the mean density over rho0 = 1. Offsets from 1 keep the digits of the squares.
std::vector<Window> windows_of(const CsvTable& series) {
  std::vector<Window> windows;
  const std::vector<double> time = series.column("time"), density = series.column("mean_density");
  for (size_t i = 0; i < time.size(); ++i) {
    const auto place = static_cast<size_t>(std::max(0.0, std::ceil(time[i] / window - 1e-9) - 1));
    while (windows.size() <= place)
      windows.push_back(
          {.from = window * static_cast<double>(windows.size()), .least = 1e300, .most = -1e300});
    Window& w = windows[place];
    const double offset = density[i] - 1;
    w.least = std::min(w.least, offset);
    w.most = std::max(w.most, offset);
    w.sum += offset;
    w.squares += offset * offset;
    ++w.steps;
  }
  return windows;
}

/// Of each run, a window after the other.
using Amplitudes = std::map<std::string, std::vector<double>>;

std::string text_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.1e}", text.empty() ? "" : ", ", value);
  return text;
}

/// What [Hunkler 2022, section 6.3] says of its curves; nothing when one of them is missing.
TextTable verdicts_of(const Amplitudes& amplitudes) {
  Verdicts verdicts;
  const std::vector<std::string> runs{"SSPH, k = 1e4", "SSPH, k = 1e5", "SSPH, k = 1e6", "IISPH"};
  std::vector<double> late, change;
  for (const std::string& run : runs) {
    const auto found = amplitudes.find(run);
    if (found == amplitudes.end() || found->second.size() < 2) return verdicts.table();
    late.push_back(found->second.back());
    change.push_back(found->second.back() / found->second.front());
  }
  verdicts.add("SSPH's oscillations weaken with k", "weaken",
               fmt::format("last amplitudes {}", text_of({late[0], late[1], late[2]})),
               late[0] > late[1] && late[1] > late[2]);
  verdicts.add("IISPH hardly oscillates", "hardly to be seen",
               fmt::format("last amplitude {:.1e}, SSPH's least {:.1e}", late[3], late[2]),
               late[3] < late[2]);
  verdicts.add(
      "amplitudes become smaller with time in all four", "smaller",
      fmt::format("last over first {}", text_of(change)), *std::ranges::max_element(change) < 1,
      fmt::format("IISPH's first window is its settling; its windows: {}", text_of(amplitudes.at("IISPH"))));
  return verdicts.table();
}

}  // namespace

std::vector<Point> density_points() {
  return {run("iisph", "6.9", "IISPH", {}),
          ssph("6.10", "1e4", "0.1"),
          ssph("6.11", "1e5", "0.05"),
          ssph("6.12", "1e6", "0.01"),
          run("iisph_recommended", "", "IISPH, recommended", recommended),
          run("iisph_for_pressure", "", "IISPH, for pressure", with(recommended, quiet_pressure))};
}

Report density_report(const std::vector<Result>& results) {
  TextTable series{{"figure", "run", "step", "time", "mean_density"}, {}};
  TextTable windows{{"figure", "run", "from", "to", "mean", "amplitude", "largest"}, {}};
  TextTable page{{"figure", "run", "dt", "steps", "mean density - 1"}, {}};
  for (double from = 0; from < duration; from += window)
    page.columns.push_back(fmt::format("amplitude, t = {:g} to {:g}", from, from + window));
  Amplitudes amplitudes;
  for (const Result& result : results) {
    const CsvTable table = read_csv(result.files.series);
    const std::string &figure = result.point.fact("figure"), &run = result.point.fact("run");
    for (size_t i = 0; i < table.size(); ++i)
      series.rows.push_back(
          {figure, run, table.text(i, "step"), table.text(i, "time"), table.text(i, "mean_density")});
    const std::vector<Window> found = windows_of(table);
    std::vector<std::string> row{figure, run, digits(result.number("settings/time/dt"), 3),
                                 std::to_string(table.size()), fmt::format("{:.1e}", found.back().mean())};
    for (const Window& w : found) {
      windows.rows.push_back({figure, run, digits(w.from), digits(w.from + window), digits(1 + w.mean(), 9),
                              digits(w.amplitude()), digits(w.largest())});
      row.push_back(fmt::format("{:.1e}", w.amplitude()));
    }
    page.rows.push_back(row);
    for (const Window& w : found) amplitudes[run].push_back(w.amplitude());
  }
  Report report;
  const TextTable verdicts = verdicts_of(amplitudes);
  report.tables = {{"density", series}, {"density_windows", windows}, {"density_verdicts", verdicts}};
  report.page = page.markdown();
  if (!verdicts.rows.empty()) report.page += fmt::format("\n{}", verdicts.markdown());
  return report;
}

}  // namespace sluice::study
