// Errors of the runs, and who is cheapest at equal error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "media/recording.hpp"
#include "studies/pareto.hpp"
#include "studies/pareto_scenes.hpp"

namespace sluice::study {

double distance_between(const Result& one, const Result& other, double at) {
  const auto displacement = [&](const Result& result) {
    const media::Recording recording(result.files.recording);
    const media::Moment start = recording.moment(0);
    for (size_t frame = 0; frame < recording.frames(); ++frame) {
      media::Moment moment = recording.moment(frame);
      if (std::abs(moment.report.time - at) > 1e-6 * at) continue;
      for (size_t i = 0; i < moment.state.x.size(); ++i) moment.state.x[i] -= start.state.x[i];
      return moment.state.x;
    }
    return std::vector<Vec2>();
  };
  const std::vector<Vec2> a = displacement(one), b = displacement(other);
  if (a.size() != b.size() || a.empty()) return unknown_number;
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size())) / one.number("settings/particles/spacing");
}

namespace {

using namespace pareto;

const ParetoScene& scene_of(const std::string& name) {
  const auto found =
      std::ranges::find_if(pareto_scenes(), [&](const ParetoScene& scene) { return scene.name == name; });
  return *found;
}

struct Errors {
  double seconds = unknown_number, mean = unknown_number, max = unknown_number, distance = unknown_number,
         reference = unknown_number;
};

bool is_converged(const Result& result) { return result.point.fact("family") == converged; }

const Result* converged_for(const std::vector<Result>& results, const Result& result) {
  const std::string stem = fmt::format("{}_{}_{}_", result.point.fact("scene"),
                                       result.point.fact("compared_with"), result.point.fact("n"));
  const auto found = std::ranges::find_if(results, [&](const Result& other) {
    return is_converged(other) && other.point.name.starts_with(stem);
  });
  return found == results.end() ? nullptr : &*found;
}

Errors errors_of(const std::vector<Result>& results, const Result& result) {
  if (!result.valid()) return {};
  const ParetoScene& scene = scene_of(result.point.fact("scene"));
  Errors errors{result.number("seconds/total") / result.number("time"), result.number("compression_mean"),
                result.number("compression_max")};
  if (const Result* converged = converged_for(results, result);
      converged != nullptr && scene.before_chaos > 0)
    errors.distance = distance_between(result, *converged, scene.before_chaos);
  for (const Measure& measure : scene.validation().measure(result)) {
    if (measure.quantity == scene.quantity) errors.reference = measure.error;
  }
  return errors;
}

struct Kind {
  const char* name;
  double Errors::*error;
  bool of_ssph;     ///< targets: what SSPH has with each of its stiffnesses, or else multiples of the least
  double resolved;  ///< no target is less: of a distance, what is known of the runs that are compared with
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"mean compression", &Errors::mean, true, 0},
                                     {"largest compression", &Errors::max, true, 0},
                                     {"distance to a converged run, in h", &Errors::distance, false, 0.06},
                                     {"error against the reference", &Errors::reference, false, 0}};
  return all;
}

struct Observed {
  const Result* result;
  Errors errors;
};

std::vector<Trade> trades_of(const std::vector<Observed>& all, const std::string& scene, const Kind& kind) {
  std::vector<Trade> trades;
  for (const auto& [result, errors] : all) {
    const Point& point = result->point;
    if (point.fact("scene") != scene || point.fact("machine") != on_double ||
        point.fact("n") != std::to_string(fine) || std::isnan(errors.*kind.error))
      continue;
    // Distances to different runs don't compare; with another wall the same start is compared.
    const std::string& with = point.fact("compared_with");
    if (kind.error == &Errors::distance && with != "converged" && with != "converged_akinci") continue;
    trades.push_back({scene, point.fact("family"), point.fact("curve"),
                      fmt::format("{}, dt = {}", point.fact("curve"), point.fact("dt")), errors.seconds,
                      errors.*kind.error});
  }
  return trades;
}

TextTable best_table(const std::vector<Observed>& all) {
  TextTable table{{"scene", "error", "at most", "the cheapest, and how much longer the others take"}, {}};
  for (const ParetoScene& scene : pareto_scenes()) {
    for (const Kind& kind : kinds()) {
      const std::vector<Trade> trades = trades_of(all, scene.name, kind);
      if (trades.empty()) continue;
      std::vector<double> targets{3 * least_error(trades), 1.5 * least_error(trades)};
      if (kind.of_ssph) targets = errors_of_curves(trades, "SSPH");
      for (double& target : targets) target = std::max(target, kind.resolved);
      targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
      for (const Cheapest& cheapest : cheapest_at(trades, targets))
        table.rows.push_back(
            {scene.name, kind.name, fmt::format("{:.2g}", cheapest.target), words_for(cheapest)});
    }
  }
  return table;
}

/// A curve on the CPU in double and float and on the GPU.
TextTable machines_table(const std::vector<Observed>& all) {
  TextTable table{{"scene", "curve", "dt", "machine", "seconds per unit of time", "mean compression",
                   "distance, in h", "error against the reference"},
                  {}};
  for (const auto& [result, errors] : all) {
    const Point& point = result->point;
    if (point.fact("n") != std::to_string(coarse)) continue;
    table.rows.push_back({point.fact("scene"), point.fact("curve"), point.fact("dt"), point.fact("machine"),
                          digits(errors.seconds, 3), digits(errors.mean, 3), digits(errors.distance, 3),
                          digits(errors.reference, 3)});
  }
  return table;
}

/// What float costs and changes, at the finer resolution.
std::string float_words(const std::vector<Observed>& all) {
  std::vector<double> times, changes;
  for (const auto& [result, errors] : all) {
    if (result->point.fact("machine") != on_double || result->point.fact("n") != std::to_string(fine))
      continue;
    for (const auto& [other, in_float] : all) {
      const auto same = [&one = other->point, &two = result->point](const char* fact) {
        return one.fact(fact) == two.fact(fact);
      };
      if (other->point.fact("machine") != on_float || !same("scene") || !same("curve") || !same("dt") ||
          !same("n"))
        continue;
      times.push_back(in_float.seconds / errors.seconds);
      changes.push_back(std::abs(in_float.mean / errors.mean - 1));
    }
  }
  if (times.empty()) return "";
  std::ranges::sort(times);
  std::ranges::sort(changes);
  return fmt::format(
      "N = {}: {} runs in float take {:.2f} times the time of those in double (median), and half of "
      "them change the mean compression by less than {:.1f} % of itself.\n",
      fine, times.size(), times[times.size() / 2], 100 * changes[changes.size() / 2]);
}

}  // namespace

Report pareto_report(const std::vector<Result>& results) {
  std::vector<Result> shown = results;
  std::erase_if(shown, is_converged);
  std::vector<Observed> all;
  for (const Result& result : shown) all.push_back({&result, errors_of(results, result)});
  Report report;
  report.tables = {{"pareto", tidy(shown,
                                   {"valid", "seconds_per_time", "compression_mean", "compression_max",
                                    "distance", "reference_error", "lost"},
                                   [&](const Result& result) -> std::vector<std::string> {
                                     const Errors& e =
                                         all[static_cast<size_t>(&result - shown.data())].errors;
                                     return {result.valid() ? "1" : "0",
                                             digits(e.seconds),
                                             digits(e.mean),
                                             digits(e.max),
                                             digits(e.distance),
                                             digits(e.reference),
                                             digits(result.number("lost"))};
                                   })}};
  const TextTable best = best_table(all);
  report.tables.push_back({"pareto_best", best});
  report.page = fmt::format("{}\n{}\n{}", best.markdown(), machines_table(all).markdown(), float_words(all));
  return report;
}

}  // namespace sluice::study
