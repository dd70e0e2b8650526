// Points and the tables; the verdicts are in cost_verdicts.cpp.
#include "studies/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/settings.hpp"

namespace sluice::study {
namespace {

constexpr int repeats = 3;
constexpr const char *jacobi = "IISPH, Jacobi", *barzilai_borwein = "IISPH, Barzilai-Borwein", *ssph = "SSPH",
                     *jittered = "SSPH, jittered";
constexpr int starts = 9;

Point point_of(const Published& row, const std::string& method, const std::string& stem,
               std::vector<std::string> overrides, int repeat) {
  Point point{.name = fmt::format("{}_{}_dt{}_{}", row.scene, stem, row.dt, repeat),
              .scene = row.scene,
              .overrides = std::move(overrides)};
  point.overrides.push_back(fmt::format("time.dt={}", row.dt));
  const double share = 100 * row.pressure_seconds / row.step_seconds;
  const bool iisph = method.starts_with("IISPH");
  point.facts = {{"scene", row.scene},
                 {"method", method},
                 {"dt", row.dt},
                 {"repeat", fmt::format("{}", repeat)},
                 {"their_iterations", iisph ? digits(row.iterations) : ""},
                 {"their_pressure_s", digits(row.pressure_seconds)},
                 {"their_step_s", digits(row.step_seconds)},
                 {"their_share", digits(share, 3)}};
  point.quick = std::string(row.scene) == "breaking_dam" && repeat == 0;
  return point;
}

void add_points(std::vector<Point>& points, const Published& row, int repeat) {
  if (std::string(row.method) == ssph) {
    points.push_back(point_of(row, ssph, "ssph", {"pressure.method=ssph"}, repeat));
    return;
  }
  points.push_back(point_of(row, jacobi, "jacobi", {}, repeat));
  points.push_back(point_of(row, barzilai_borwein, "bb", recommended, repeat));
}

/// Of the stages that the pressure is made by. The thesis counts the acceleration by it only where it is part
/// of the iteration.
double pressure_seconds(const Result& result) {
  const bool iisph = result.point.fact("method").starts_with("IISPH");
  double sum = 0;
  for (const char* stage : {"state_equation", "diagonal", "source", "warm_start", "pressure_acceleration",
                            "pressure_operator", "residual", "stop_test", "pressure_update", "pressure"}) {
    const auto& stages = result.summary.at("seconds").at("stages");
    const bool counts = iisph || std::string(stage) == "state_equation";
    if (counts && stages.contains(stage)) sum += stages.at(stage).get<double>();
  }
  return sum;
}

std::vector<Starts> starts_of(const std::vector<Result>& results) {
  std::vector<Starts> all;
  for (const Result& result : results) {
    if (result.point.fact("method") != jittered) continue;
    const std::string& dt = result.point.fact("dt");
    if (all.empty() || all.back().dt != dt) all.push_back({dt});
    Starts& those = all.back();
    ++those.starts;
    if (result.number("lost") > 0) ++those.with_losses;
    those.cfl_max = std::max(those.cfl_max, result.number("cfl_max"));
  }
  return all;
}

TextTable starts_table(const std::vector<Starts>& all) {
  TextTable table{{"dt", "starts", "with lost particles", "largest cfl"}, {}};
  for (const Starts& those : all)
    table.rows.push_back({those.dt, std::to_string(those.starts), std::to_string(those.with_losses),
                          fmt::format("{:.2f}", those.cfl_max)});
  return table;
}

std::vector<Cost> costs_of(const std::vector<Result>& results) {
  std::vector<Cost> costs;
  for (const Result& result : results) {
    if (result.point.fact("method") == jittered) continue;
    const Cost cost{result.point.fact("scene"),
                    result.point.fact("method"),
                    result.point.fact("dt"),
                    result.number("iterations_mean"),
                    pressure_seconds(result),
                    result.number("seconds/total"),
                    result.number("compression_mean"),
                    result.number("cfl_max"),
                    result.number("lost"),
                    result.valid()};
    const auto same = std::ranges::find_if(costs, [&](const Cost& other) {
      return other.scene == cost.scene && other.method == cost.method && other.dt == cost.dt;
    });
    if (same == costs.end())
      costs.push_back(cost);
    else if (cost.step_seconds < same->step_seconds)
      *same = cost;
  }
  return costs;
}

std::string fixed(double value, int places) {
  return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, places);
}

TextTable page_table(const std::vector<Cost>& costs, const std::string& scene) {
  TextTable table{{"method", "dt", "iterations, thesis", "ours", "pressure / step s, thesis", "share",
                   "pressure / step s, ours", "share", "mean compression", "largest cfl", "lost"},
                  {}};
  for (const Cost& cost : costs) {
    if (cost.scene != scene) continue;
    const auto row = std::ranges::find_if(published_costs(), [&](const Published& theirs) {
      return theirs.scene == scene && theirs.dt == cost.dt && cost.method.starts_with(theirs.method);
    });
    const bool theirs = cost.method != barzilai_borwein && !std::isnan(row->step_seconds);
    const auto share = [](double part, double whole) { return fmt::format("{:.1f} %", 100 * part / whole); };
    table.rows.push_back(
        {cost.method, cost.dt, theirs ? fixed(row->iterations, 2) : "",
         cost.method == ssph ? "" : fixed(cost.iterations, 2),
         theirs ? fmt::format("{:.5g} / {:.5g}", row->pressure_seconds, row->step_seconds) : "",
         theirs ? share(row->pressure_seconds, row->step_seconds) : "",
         cost.valid ? fmt::format("{:.3g} / {:.3g}", cost.pressure_seconds, cost.step_seconds)
                    : "became invalid",
         cost.valid ? share(cost.pressure_seconds, cost.step_seconds) : "",
         fmt::format("{:.1e}", cost.compression), fmt::format("{:.2f}", cost.cfl_max), digits(cost.lost)});
  }
  return table;
}

}  // namespace

const std::vector<Published>& published_costs() {
  static const std::vector<Published> rows{
      {"breaking_dam", "IISPH", "0.01", 2.00, 48.24, 143.49},
      {"breaking_dam", "IISPH", "0.02", 2.38, 27.37, 73.91},
      {"breaking_dam", "IISPH", "0.03", 4.87, 32.28, 65.07},
      {"breaking_dam", "IISPH", "0.04", 8.45, 38.55, 62.38},
      {"breaking_dam", "IISPH", "0.05", 12.87, 44.48, 63.41},
      {"breaking_dam", "IISPH", "0.06", 18.04, 50.92, 66.5},
      {"breaking_dam", "IISPH", "0.08", 30.01, 62.52, 74.21},
      {"breaking_dam", "SSPH", "0.01", unknown_number, 0.241, 98.09},
      {"breaking_dam", "SSPH", "0.011", unknown_number, unknown_number, unknown_number},
      {"breaking_dam", "SSPH", "0.019", unknown_number, unknown_number, unknown_number},
      {"leaking_dam", "IISPH", "0.004", 2, 326.94, 988.52},
      {"leaking_dam", "IISPH", "0.005", 2.76, 324.73, 843.64},
      {"leaking_dam", "IISPH", "0.006", 3.97, 352.95, 777.8},
      {"leaking_dam", "IISPH", "0.008", 6.87, 423.05, 749.99},
      {"leaking_dam", "IISPH", "0.01", 10.24, 484.2, 738.65},
      {"leaking_dam", "IISPH", "0.012", 14.61, 560.69, 777.3},
      {"leaking_dam", "IISPH", "0.015", 22.53, 685.44, 857.31},
      {"leaking_dam", "IISPH", "0.02", 38.82, 858.17, 987.67},
      {"leaking_dam", "SSPH", "0.004", unknown_number, 1.49, 649.78},
      {"leaking_dam", "SSPH", "0.0045", unknown_number, unknown_number, unknown_number},
  };
  return rows;
}

std::vector<Point> cost_points() {
  std::vector<Point> points;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (const Published& row : published_costs()) add_points(points, row, repeat);
  }
  for (const char* dt : {"0.01", "0.011", "0.014", "0.016", "0.019"}) {
    for (int start = 0; start < starts; ++start) {
      points.push_back(point_of(
          {"breaking_dam", ssph, dt, unknown_number, unknown_number, unknown_number}, jittered, "jittered",
          {"pressure.method=ssph", "fluid.jitter=1e-6", fmt::format("fluid.seed={}", start)}, start));
    }
  }
  return points;
}

Report cost_report(const std::vector<Result>& results) {
  Report report;
  const std::vector<Cost> costs = costs_of(results);
  const std::vector<Starts> strays = starts_of(results);
  const TextTable verdicts = cost_verdicts(costs, strays);
  report.tables = {
      {"cost",
       tidy(results,
            {"iterations", "pressure_s", "step_s", "share", "compression_mean", "cfl_max", "lost", "valid"},
            [](const Result& result) -> std::vector<std::string> {
              const double pressure = pressure_seconds(result), step = result.number("seconds/total");
              return {digits(result.number("iterations_mean")),
                      digits(pressure),
                      digits(step),
                      digits(100 * pressure / step, 3),
                      digits(result.number("compression_mean")),
                      digits(result.number("cfl_max")),
                      digits(result.number("lost")),
                      result.valid() ? "1" : "0"};
            })},
      {"cost_verdicts", verdicts}};
  for (const char* scene : {"breaking_dam", "leaking_dam"}) {
    const TextTable table = page_table(costs, scene);
    if (!table.rows.empty()) report.page += fmt::format("`{}`\n\n{}\n", scene, table.markdown());
  }
  if (!strays.empty())
    report.page += fmt::format("SSPH on `breaking_dam` from starts jittered by 1e-6 h\n\n{}\n",
                               starts_table(strays).markdown());
  report.page += verdicts.markdown();
  return report;
}

}  // namespace sluice::study
