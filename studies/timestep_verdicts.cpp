// Limits of each configuration, exponents, and the verdicts.
#include "studies/timestep_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "studies/time_curve.hpp"
#include "studies/timestep.hpp"
#include "studies/verdicts.hpp"

namespace sluice::study {
namespace {

struct Configuration {
  std::string figure, method;
  double h = 0, k = 0, nu = 0;
  auto operator<=>(const Configuration&) const = default;
};

using Limits = std::map<Configuration, StepLimit>;

double number_or_0(const std::string& text) { return text.empty() ? 0 : std::stod(text); }

Configuration configuration_of(const Point& point) {
  return {point.fact("figure"), point.fact("method"), std::stod(point.fact("h")),
          number_or_0(point.fact("k")), std::stod(point.fact("nu"))};
}

Limits limits_of(const std::vector<Result>& results) {
  std::map<Configuration, std::vector<Trial>> trials;
  for (const Result& result : results) {
    if (!is_trial(result)) continue;
    trials[configuration_of(result.point)].push_back(
        {std::stod(result.point.fact("dt")), std::stoi(result.point.fact("start")),
         result.valid() ? result.number("cfl_max") : std::numeric_limits<double>::infinity(),
         result.number("lost")});
  }
  std::map<Configuration, double> planned;  // a grid may be there in part only
  for (const Point& point : timestep_points()) {
    double& largest = planned.emplace(configuration_of(point), 0.0).first->second;
    largest = std::max(largest, std::stod(point.fact("dt")));
  }
  Limits limits;
  for (const auto& [configuration, tried] : trials) {
    limits[configuration] = step_limit(tried);
    limits[configuration].at_the_end = limits[configuration].dt >= planned[configuration];
  }
  return limits;
}

TextTable limits_table(const Limits& limits) {
  TextTable table{{"figure", "method", "h", "k", "nu", "dt", "steady", "least", "most", "starts", "dt / h",
                   "lost", "beyond the grid"},
                  {}};
  for (const auto& [c, limit] : limits) {
    table.rows.push_back({c.figure, c.method, digits(c.h), c.k > 0 ? fmt::format("{:g}", c.k) : "",
                          digits(c.nu), digits(limit.dt, 4), digits(limit.steady, 4), digits(limit.least, 4),
                          digits(limit.most, 4), std::to_string(limit.starts), digits(limit.dt / c.h, 3),
                          digits(limit.lost), limit.at_the_end ? "yes" : ""});
  }
  return table;
}

const Configuration usual{"", "", 10, 1e5, 200};

/// One quantity varied, the others kept.
struct Curve {
  std::vector<double> x, dt;

  size_t highest() const { return static_cast<size_t>(std::ranges::max_element(dt) - dt.begin()); }
};

Curve curve_of(const Limits& limits, const std::string& method, double Configuration::*varied,
               double StepLimit::*limit_of, Configuration fixed = usual) {
  std::map<double, double> dt;  // points of a curve may be in different figures
  for (const auto& [c, limit] : limits) {
    fixed.*varied = c.*varied;
    fixed.figure = c.figure;
    fixed.method = method;
    if (method == "IISPH") fixed.k = 0;
    if (c == fixed && limit.*limit_of > 0) dt[c.*varied] = limit.*limit_of;
  }
  Curve curve;
  for (const auto& [x, y] : dt) {
    curve.x.push_back(x);
    curve.dt.push_back(y);
  }
  return curve;
}

double slope(const Curve& curve) { return slope_of({curve.x, curve.dt}); }

/// Only its points from `least` on.
Curve from(const Curve& curve, double least) {
  Curve part;
  for (size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] < least) continue;
    part.x.push_back(curve.x[i]);
    part.dt.push_back(curve.dt[i]);
  }
  return part;
}

/// Which of two ways to read a limit a verdict is of, and the other one.
constexpr double StepLimit::*largest = &StepLimit::dt;
constexpr double StepLimit::*steady = &StepLimit::steady;
constexpr const char* with_steady = "with the steps up to which all pass: ";

void judge_spacing(const Limits& limits, Verdicts& verdicts) {
  const auto curve = [&](const char* method, double StepLimit::*which) {
    return curve_of(limits, method, &Configuration::h, which);
  };
  const Curve iisph = curve("IISPH", largest), ssph = curve("SSPH", largest);
  if (iisph.x.size() < 2 || ssph.x.size() < 2) return;
  const Curve iisph_steady = curve("IISPH", steady), ssph_steady = curve("SSPH", steady);
  const double power = exponent(iisph.x, iisph.dt);
  verdicts.add("Fig. 6.6: IISPH's largest dt is about linear in h", "straight line but for h = 20",
               fmt::format("exponent {:.2f}", power), std::abs(power - 1) < 0.3,
               fmt::format("{}{:.2f}", with_steady, exponent(iisph_steady.x, iisph_steady.dt)));
  verdicts.add("Fig. 6.6: and steeper than SSPH's (k = 1e5)", "steeper",
               fmt::format("slopes {:.4f} and {:.4f}", slope(iisph), slope(ssph)), slope(iisph) > slope(ssph),
               fmt::format("{}{:.4f} and {:.4f}", with_steady, slope(iisph_steady), slope(ssph_steady)));
  const auto ten = limits.find({"6.6", "IISPH", 10, 0, 200});
  if (ten == limits.end()) return;
  verdicts.add("IISPH at h = 10", "0.075",
               fmt::format("{:.4f} ({:.4f} to {:.4f} over {} starts)", ten->second.dt, ten->second.least,
                           ten->second.most, ten->second.starts),
               ten->second.dt >= 0.07 && ten->second.dt <= 0.08,
               fmt::format("{}{:.4f}", with_steady, ten->second.steady));
}

/// The stiffness whose limit is nearest to this one.
size_t nearest(const Curve& curve, double dt) {
  size_t found = 0;
  for (size_t i = 0; i < curve.x.size(); ++i) {
    if (std::abs(curve.dt[i] - dt) < std::abs(curve.dt[found] - dt)) found = i;
  }
  return found;
}

void judge_stiffness(const Limits& limits, Verdicts& verdicts) {
  const Curve curve = curve_of(limits, "SSPH", &Configuration::k, largest);
  const Curve lower = curve_of(limits, "SSPH", &Configuration::k, steady);
  if (curve.x.size() < 4 || lower.x.empty()) return;
  const bool falling = std::ranges::is_sorted(curve.dt, std::greater<>());
  verdicts.add("Fig. 6.7: SSPH's largest dt falls with k", "falls",
               fmt::format("{:.4f} at k = {:g}, {:.4f} at {:g}", curve.dt.front(), curve.x.front(),
                           curve.dt.back(), curve.x.back()),
               falling);
  const Curve stiff = from(curve, 1e5), lower_stiff = from(lower, 1e5);
  const double power = exponent(stiff.x, stiff.dt);
  verdicts.add("from k = 1e5 on about as k^-1/2", "(not given)", fmt::format("exponent {:.2f}", power),
               std::abs(power + 0.5) < 0.1,
               fmt::format("{}{:.2f}", with_steady, exponent(lower_stiff.x, lower_stiff.dt)));
  const auto iisph = limits.find({"6.6", "IISPH", 10, 0, 200});
  if (iisph == limits.end()) return;
  const size_t found = nearest(curve, iisph->second.dt), below = nearest(lower, iisph->second.steady);
  verdicts.add(
      "Fig. 6.7: SSPH has IISPH's dt at about k = 1e4", "1e4",
      fmt::format("nearest at k = {:g}: {:.4f}", curve.x[found], curve.dt[found]),
      curve.x[found] >= 5e3 && curve.x[found] <= 2e4,
      fmt::format("single lucky steps pass far above those that fail; {}k = {:g}: {:.4f} against {:.4f}",
                  with_steady, lower.x[below], lower.dt[below], iisph->second.steady));
}

void judge_viscosity(const Limits& limits, Verdicts& verdicts) {
  for (const std::string method : {"IISPH", "SSPH"}) {
    const Curve curve = curve_of(limits, method, &Configuration::nu, largest);
    if (curve.x.size() < 4) continue;
    const double at = curve.x[curve.highest()];
    verdicts.add(fmt::format("Fig. 6.8: {} has the largest dt at a viscosity in the middle", method),
                 "a hump at 300 to 500",
                 fmt::format("largest {:.4f} at nu = {:g}, {:.4f} at nu = {:g}, {:.4f} at nu = {:g}",
                             curve.dt[curve.highest()], at, curve.dt.front(), curve.x.front(),
                             curve.dt.back(), curve.x.back()),
                 at >= 300 && at <= 600);
  }
}

}  // namespace

void add_timestep_limits(const std::vector<Result>& results, Report& report) {
  const Limits limits = limits_of(results);
  Verdicts verdicts;
  judge_spacing(limits, verdicts);
  judge_stiffness(limits, verdicts);
  judge_viscosity(limits, verdicts);
  judge_coherence(results, verdicts);
  const TextTable table = limits_table(limits);
  report.tables.push_back({"timestep_limits", table});
  report.tables.push_back({"timestep_verdicts", verdicts.table()});
  report.page = fmt::format("{}\n{}", table.markdown(), verdicts.table().markdown());
  for (const auto& [c, limit] : limits) {
    if (limit.dt > 0 && !limit.at_the_end) continue;
    report.faults.push_back(
        fmt::format("{} at h = {:g}, k = {:g}, nu = {:g}: the limit is {} the grid of time steps", c.method,
                    c.h, c.k, c.nu, limit.dt > 0 ? "above" : "below"));
  }
}

}  // namespace sluice::study
