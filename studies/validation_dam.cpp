// A column of water that collapses: front and height of the experiments, energy.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "media/recording.hpp"
#include "studies/csv_table.hpp"
#include "studies/validation_waters.hpp"

namespace sluice {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The height is that of the water in the first tenth of the column's width.
constexpr double wall_strip = 0.1;

/// What the recording of a collapse shows; a = g = 1.
struct Collapse {
  TimeCurve front, height;
  double energy = 0;  ///< of the start, kinetic and potential
};

Collapse collapse_of(const Recording& recording) {
  const Scene& scene = recording.scene();
  const double h = scene.spacing, face = wall_faces * h;
  Collapse collapse;
  for (size_t frame = 0; frame < recording.frames(); ++frame) {
    const Moment moment = recording.moment(frame);
    const Snapshot& state = moment.state;
    if (frame == 0)
      for (size_t i = 0; i < state.x.size(); ++i)
        collapse.energy += scene.mass() * (dot(state.v[i], state.v[i]) / 2 - dot(scene.gravity, state.x[i]));
    const std::vector<Vec2> bulk = connected_bulk(state.x, 2 * h);
    // A particle is the middle of its water.
    collapse.front.add(moment.report.time * std::sqrt(2.0), front_of(bulk) + h / 2 - face);
    collapse.height.add(moment.report.time, (height_at_wall(bulk, face + wall_strip) + h / 2 - face) / 2);
  }
  return collapse;
}

Measure energy_of(const Result& result, const Collapse& collapse) {
  const CsvTable series = read_csv(result.files.series);
  const double h = result.number("settings/particles/spacing");
  const double mass = result.number("fluid") * result.number("settings/particles/rest_density") * h * h;
  const double scale = collapse.energy - mass * wall_faces * h;  // what the column may fall
  const double rise = largest_rise(series.column("kinetic_energy"), series.column("potential_energy"),
                                   collapse.energy, scale);
  return {"energy", unknown, unknown, rise};
}

std::vector<Measure> measure(const Result& result) {
  const Collapse ours = collapse_of(Recording(result.files.recording));
  const auto reference = [&](const char* file) { return reference_beside(result.point.scene, file); };
  const TimeCurve height = reference("martin_moyce_height.csv"), front = reference("martin_moyce_front.csv"),
                  koshizuka = reference("koshizuka_oka_front.csv");
  const double end = front.time.back();
  // The gate of the experiment takes time to open; 0.25 is about what it needs.
  const double delay = fitted_delay(ours.front, front, -0.5, 1);
  return {{"height", unknown, unknown, distance(ours.height, height, false)},
          {"front", ours.front.at(end), front.value.back(), distance(ours.front, front, true)},
          {"front_offset", delay, unknown, distance(ours.front, front, true, delay)},
          {"front_koshizuka", ours.front.at(koshizuka.time.back()), koshizuka.value.back(),
           distance(ours.front, koshizuka, true)},
          energy_of(result, ours)};
}

std::vector<std::string> iisph(int n) { return {fmt::format("time.dt={:.17g}", 0.16 / n)}; }

std::vector<std::string> iisph_unsmoothed(int n) {
  std::vector<std::string> settings = iisph(n);
  settings.push_back("particles.smoothing=1");
  return settings;
}

std::vector<std::string> iisph_lattice(int n) {
  std::vector<std::string> settings = iisph(n);
  settings.insert(settings.end(), {"fluid.jitter=0", "fluid.relax=0"});
  return settings;
}

/// A state equation is not at peace with the mirror wall unless viscosity takes what the wall gives.
std::vector<std::string> state_equation(const char* method, int n) {
  return {fmt::format("pressure.method={}", method), "boundary.model=akinci",
          fmt::format("pressure.{}.dt={:.17g}", method, 0.028 / n)};
}
std::vector<std::string> ssph(int n) { return state_equation("ssph", n); }
std::vector<std::string> wcsph(int n) { return state_equation("wcsph", n); }

}  // namespace

double front_of(const std::vector<Vec2>& bulk) {
  double front = -std::numeric_limits<double>::infinity();
  for (const Vec2& x : bulk) front = std::max(front, x.x);
  return front;
}

double height_at_wall(const std::vector<Vec2>& bulk, double until) {
  double least = std::numeric_limits<double>::infinity(), height = -least;
  for (const Vec2& x : bulk) {
    least = std::min(least, x.y);
    if (x.x < until) height = std::max(height, x.y);
  }
  return std::max(height, least);
}

double largest_rise(const std::vector<double>& kinetic, const std::vector<double>& potential, double start,
                    double scale) {
  double rise = 0;
  for (size_t i = 0; i < kinetic.size(); ++i)
    rise = std::max(rise, (kinetic[i] + potential[i] - start) / scale);
  return rise;
}

ValidationCase dam_case() {
  return {.name = "dam_break",
          .limits = {{"height", 0.03, 0.015}, {"front_offset", 0.025, 0.012}, {"energy", 0.005, 0.005}},
          .variants = {{"iisph", "IISPH, recommended", iisph},
                       {"iisph_unsmoothed", "IISPH, smoothing 1", iisph_unsmoothed},
                       {"iisph_lattice", "IISPH, from a lattice", iisph_lattice},
                       {"ssph", "SSPH", ssph},
                       {"wcsph", "WCSPH", wcsph}},
          .words = {"--fps", "12"},
          .series = true,
          .recording = true,
          .measure = measure};
}

}  // namespace sluice
