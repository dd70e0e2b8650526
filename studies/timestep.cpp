// Points: a grid of time steps 2.5 % apart for each configuration, nine starts each; and six whole runs that
// say whether a fluid without viscosity stays together.
#include "studies/timestep.hpp"

#include <fmt/format.h>

#include <cmath>

#include "studies/timestep_verdicts.hpp"

namespace sluice::study {
namespace {

constexpr double ratio = 1.025;
constexpr int starts = 9, quick_starts = 3;
/// The spacing from which on runs are so short that they are part of --quick.
constexpr double quick_spacing = 16;

std::vector<std::string> scene_of(const std::string& method, double h, double k, double nu, double dt) {
  std::vector<std::string> overrides{"fluid.rect.0.max=[200,\"300+3h\"]", "pressure.method=" + method,
                                     fmt::format("particles.spacing={:.17g}", h),
                                     fmt::format("viscosity.coefficient={:g}", nu),
                                     fmt::format("time.dt={:.6g}", dt)};
  if (method == "ssph") overrides.push_back(fmt::format("pressure.ssph.stiffness={:g}", k));
  return overrides;
}

Point point_of(const std::string& figure, const std::string& method, double h, double k, double nu, double dt,
               int start) {
  Point point{
      .name = fmt::format("fig_{}_{}_h{:g}_k{:g}_nu{:g}_dt{:.6g}_{}", figure, method, h, k, nu, dt, start),
      .scene = "breaking_dam",
      .overrides = scene_of(method, h, k, nu, dt)};
  point.facts = {{"figure", figure},
                 {"method", method == "ssph" ? "SSPH" : "IISPH"},
                 {"h", fmt::format("{:g}", h)},
                 {"k", k > 0 ? fmt::format("{:g}", k) : ""},
                 {"nu", fmt::format("{:g}", nu)},
                 {"dt", fmt::format("{:.6g}", dt)},
                 {"start", fmt::format("{}", start)}};
  return point;
}

/// From `least` to `most`, all of one grid.
std::vector<double> steps_between(double least, double most) {
  std::vector<double> steps;
  const int first = static_cast<int>(std::ceil(std::log(least) / std::log(ratio)));
  for (int i = first; std::pow(ratio, i) <= most; ++i) steps.push_back(std::pow(ratio, i));
  return steps;
}

void add_trials(std::vector<Point>& points, const std::string& figure, const std::string& method, double h,
                double k, double nu, double least, double most) {
  for (const double dt : steps_between(least, most)) {
    for (int start = 0; start < starts; ++start) {
      Point point = point_of(figure, method, h, k, nu, dt, start);
      point.overrides.push_back("fluid.jitter=1e-6");
      point.overrides.push_back(fmt::format("fluid.seed={}", start));
      point.quick = figure == "6.6" && h >= quick_spacing && start < quick_starts;
      points.push_back(std::move(point));
    }
  }
}

// The grids reach from where all starts pass to where none does.

void add_iisph(std::vector<Point>& points, const std::string& figure, double h, double nu) {
  double least = 0.0052 * h, most = 0.0125 * h;
  if (nu < 200) {
    least = nu > 0 ? 0.003 * h : 0.0022 * h;
    most = nu > 0 ? 0.011 * h : 0.005 * h;
  }
  if (nu > 600) {  // the explicit viscosity sets the limit
    least = 35 / nu;
    most = 80 / nu;
  }
  add_trials(points, figure, "iisph", h, 0, nu, least, most);
}

/// SSPH blows up at about dt = 2 h / sqrt(k).
void add_ssph(std::vector<Point>& points, const std::string& figure, double h, double k, double nu) {
  const bool thick = nu > 1000;
  const double scale = h / std::sqrt(k);
  add_trials(points, figure, "ssph", h, k, nu, thick ? 35 / nu : 0.76 * scale,
             thick ? 70 / nu : 2.25 * scale);
}

/// Whole runs, of which the particles that are in the tank at the end are looked at.
Point coherence(const std::string& method, double nu, double dt) {
  Point point = point_of("6.8", method, 10, method == "ssph" ? 1e5 : 0, nu, dt, -1);
  point.name = fmt::format("coherence_{}_nu{:g}_dt{:g}", method, nu, dt);
  point.recording = point.quick = true;
  point.words = {"--fps", "1"};
  return point;
}

}  // namespace

std::vector<Point> timestep_points() {
  std::vector<Point> points;
  // Spacings that divide the width of the tank: others leave a gap between floor and wall.
  for (const int columns : {50, 45, 40, 36, 32, 28, 25, 20}) {
    const double h = 400.0 / columns;
    add_iisph(points, "6.6", h, 200);
    add_ssph(points, "6.6", h, 1e5, 200);
  }
  // k = 1e5 and nu = 200 are in figure 6.6.
  for (const double k : {1e4, 2e4, 5e4, 2e5, 5e5, 1e6, 4e6}) add_ssph(points, "6.7", 10, k, 200);
  add_iisph(points, "6.8", 10, 0);
  for (const double nu : {100, 300, 400, 500, 600, 1000, 2000}) {
    add_iisph(points, "6.8", 10, nu);
    add_ssph(points, "6.8", 10, 1e5, nu);
  }
  for (const double nu : {0, 200}) {
    points.push_back(coherence("ssph", nu, 0.01));
    points.push_back(coherence("iisph", nu, 0.01));
    points.push_back(coherence("iisph", nu, 0.03));
  }
  return points;
}

Report timestep_report(const std::vector<Result>& results) {
  Report report;
  report.tables = {{"timestep", tidy(results, {"valid", "cfl_max", "lost", "compression_mean", "seconds"},
                                     [](const Result& result) -> std::vector<std::string> {
                                       return {result.valid() ? "1" : "0", digits(result.number("cfl_max")),
                                               digits(result.number("lost")),
                                               digits(result.number("compression_mean")),
                                               digits(result.number("seconds/total"), 4)};
                                     })}};
  add_timestep_limits(results, report);
  return report;
}

}  // namespace sluice::study
