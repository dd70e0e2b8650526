// A column of water that collapses: front and height of the experiments, energy.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "media/recording.hpp"
#include "studies/csv_table.hpp"
#include "studies/settings.hpp"
#include "studies/validation_waters.hpp"

namespace sluice::study {
namespace {

/// The height is that of the water in the first tenth of the column's width.
constexpr double wall_strip = 0.1;

/// What the recording of a collapse shows; a = g = 1.
struct Collapse {
  TimeCurve front, height;
  double energy = 0;  ///< of the start, kinetic and potential
};

Collapse collapse_of(const media::Recording& recording) {
  const Scene& scene = recording.scene();
  const double h = scene.spacing, face = wall_faces * h;
  Collapse collapse;
  for (size_t frame = 0; frame < recording.frames(); ++frame) {
    const media::Moment moment = recording.moment(frame);
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
  return {"energy", unknown_number, unknown_number, rise};
}

std::vector<Measure> measure(const Result& result) {
  const Collapse ours = collapse_of(media::Recording(result.files.recording));
  const auto reference = [&](const char* file) { return reference_beside(result.point.scene, file); };
  const TimeCurve height = reference("martin_moyce_height.csv"), front = reference("martin_moyce_front.csv"),
                  koshizuka = reference("koshizuka_oka_front.csv");
  const double end = front.time.back();
  // The gate of the experiment takes time to open; 0.25 is about what it needs.
  const double delay = fitted_delay(ours.front, front, -0.5, 1);
  return {{"height", unknown_number, unknown_number, distance(ours.height, height)},
          {"front", ours.front.at(end), front.value.back(), distance(ours.front, front)},
          {"front_offset", delay, unknown_number, distance(ours.front, front, delay)},
          {"front_koshizuka", ours.front.at(koshizuka.time.back()), koshizuka.value.back(),
           distance(ours.front, koshizuka)},
          energy_of(result, ours)};
}

Settings iisph_and(int n, const Settings& more) {
  return with({fmt::format("time.dt={:.17g}", 0.16 / n)}, more);
}
Settings iisph(int n) { return iisph_and(n, {}); }
Settings iisph_unsmoothed(int n) { return iisph_and(n, {"particles.smoothing=1"}); }
Settings iisph_lattice(int n) { return iisph_and(n, {"fluid.jitter=0", "fluid.relax=0"}); }
/// Its solve ends before the pressure has found its way down a column that starts without one: the water
/// falls, and is thrown back.
Settings iisph_recommended(int n) { return iisph_and(n, {"pressure.iisph.tolerance=1e-3"}); }

Settings iisph_for_pressure(int n) { return with({fmt::format("time.dt={:.17g}", 0.3 / n)}, quiet_pressure); }

/// A state equation is not at peace with the mirror wall unless viscosity takes what the wall gives.
Settings state_equation(const char* method, int n) {
  return {fmt::format("pressure.method={}", method), "boundary.model=akinci",
          fmt::format("pressure.{}.dt={:.17g}", method, 0.028 / n)};
}
Settings ssph(int n) { return state_equation("ssph", n); }
Settings wcsph(int n) { return state_equation("wcsph", n); }

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
  double rise = 0, least = start;
  for (size_t i = 0; i < kinetic.size(); ++i) {
    const double energy = kinetic[i] + potential[i];
    least = std::min(least, energy);
    rise = std::max(rise, (energy - least) / scale);
  }
  return rise;
}

ValidationCase dam_case() {
  return {.name = "dam_break",
          .limits = {{"height", 0.03, 0.015}, {"front_offset", 0.025, 0.012}, {"energy", 0.005, 0.005}},
          .variants = {{"iisph", "IISPH, tolerance 1e-4", iisph},
                       {"iisph_recommended", "IISPH, recommended", iisph_recommended},
                       {"iisph_for_pressure", "IISPH, for pressure", iisph_for_pressure},
                       {"iisph_unsmoothed", "IISPH, tolerance 1e-4, smoothing 1", iisph_unsmoothed},
                       {"iisph_lattice", "IISPH, tolerance 1e-4, from a lattice", iisph_lattice},
                       {"ssph", "SSPH", ssph},
                       {"wcsph", "WCSPH", wcsph}},
          .words = {"--fps", "12"},
          .series = true,
          .recording = true,
          .measure = measure};
}

}  // namespace sluice::study
