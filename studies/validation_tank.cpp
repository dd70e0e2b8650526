// Water at rest in a tank: p = rho0 g depth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "media/recording.hpp"
#include "studies/csv_table.hpp"
#include "studies/settings.hpp"
#include "studies/validation_waters.hpp"

namespace sluice::study {
namespace {

/// Averages are over what is left of the run, when it has come to rest.
constexpr double at_rest_from = 0.5;

struct Tank {
  double spacing, depth, weight, begin;  ///< weight: rho0 g; begin: of the averages
};

Tank tank_of(const Result& result) {
  const double gravity = -result.summary.at("settings").at("fluid").at("gravity").at(1).get<double>();
  const double spacing = result.number("settings/particles/spacing");
  return {spacing, 1, result.number("settings/particles/rest_density") * gravity,
          at_rest_from * result.number("time")};
}

Measure pressure_of(const Result& result, const Tank& tank) {
  const media::Recording recording(result.files.recording);
  PressureBins bins(tank.spacing, wall_faces * tank.spacing);
  for (size_t frame = 0; frame < recording.frames(); ++frame) {
    const media::Moment moment = recording.moment(frame);
    if (moment.report.time >= tank.begin) bins.add(moment.state.x, moment.state.pressure);
  }
  return {"pressure", unknown_number, unknown_number, bins.error(tank.weight) / (tank.weight * tank.depth)};
}

Measure drift_of(const CsvTable& series, const Tank& tank) {
  const std::vector<double> time = series.column("time"), height = series.column("com_y");
  TimeCurve level;
  for (size_t i = 0; i < time.size(); ++i)
    if (time[i] >= tank.begin) level.add(time[i], 2 * height[i]);
  const double drift = slope_of(level) * (level.time.back() - level.time.front()) / tank.depth;
  return {"drift", drift, 0, std::abs(drift)};
}

Measure force_of(const CsvTable& series, const Tank& tank, double particles) {
  const std::vector<double> time = series.column("time"), force = series.column("wall_force_y");
  double sum = 0, steps = 0;
  for (size_t i = 0; i < time.size(); ++i) {
    if (time[i] < tank.begin) continue;
    sum -= force[i];
    steps += 1;
  }
  const double weight = tank.weight * particles * tank.spacing * tank.spacing;
  return {"force", sum / steps, weight, std::abs(sum / steps / weight - 1)};
}

std::vector<Measure> measure(const Result& result) {
  const Tank tank = tank_of(result);
  const CsvTable series = read_csv(result.files.series);
  return {pressure_of(result, tank), drift_of(series, tank), force_of(series, tank, result.number("fluid"))};
}

std::vector<std::string> iisph(int n) { return {fmt::format("time.dt={:.17g}", 0.4 / n)}; }

std::vector<std::string> iisph_for_pressure(int n) { return with(iisph(n), quiet_pressure); }

/// The mirror wall gives energy to a state equation. More viscosity takes it, and moves nothing at rest.
std::vector<std::string> state_equation(const char* method, int n) {
  return {fmt::format("pressure.method={}", method), fmt::format("viscosity.coefficient={:.17g}", 0.4 / n),
          fmt::format("pressure.{}.dt={:.17g}", method, 0.06 / n)};
}
std::vector<std::string> ssph(int n) { return state_equation("ssph", n); }
std::vector<std::string> wcsph(int n) { return state_equation("wcsph", n); }

}  // namespace

ValidationCase tank_case() {
  return {.name = "hydrostatic_tank",
          .limits = {{"pressure", 0.04, 0.015}, {"drift", 0.005, 0.001}},
          .variants = {{"iisph", "IISPH, recommended", iisph},
                       {"iisph_for_pressure", "IISPH, for pressure", iisph_for_pressure},
                       {"ssph", "SSPH", ssph},
                       {"wcsph", "WCSPH", wcsph}},
          .series = true,
          .recording = true,
          .measure = measure};
}

void PressureBins::add(const std::vector<Vec2>& x, const std::vector<double>& pressure) {
  for (size_t i = 0; i < x.size(); ++i) {
    const double height = x[i].y - floor_;
    const auto place = static_cast<size_t>(std::max(0.0, height / spacing_));
    if (place >= bins_.size()) bins_.resize(place + 1);
    bins_[place].count += 1;
    bins_[place].height += height;
    bins_[place].pressure += pressure[i];
  }
}

double PressureBins::level() const {
  double count = 0, height = 0;
  for (const Bin& bin : bins_) {
    count += bin.count;
    height += bin.height;
  }
  return 2 * height / count;
}

double PressureBins::error(double weight) const {
  double all = 0, squares = 0, used = 0;
  for (const Bin& bin : bins_) all += bin.count;
  const double full = all * spacing_ / level();
  for (const Bin& bin : bins_) {
    if (bin.count < 0.5 * full) continue;
    const double depth = level() - bin.height / bin.count;
    const double off = bin.pressure / bin.count - weight * depth;
    squares += off * off;
    used += 1;
  }
  return std::sqrt(squares / used);
}

}  // namespace sluice::study
