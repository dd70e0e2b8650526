// A standing wave between two walls: omega² = g k tanh(k H).
#include <cmath>
#include <numbers>

#include "studies/csv_table.hpp"
#include "studies/settings.hpp"
#include "studies/validation_waters.hpp"

namespace sluice::study {
namespace {

/// The scene's: half a wave from wall to wall; the depth and the gravity are 1.
constexpr double length = 2;

std::vector<Measure> measure(const Result& result) {
  const CsvTable series = read_csv(result.files.series);
  // A surface 1 + A cos(kx) has its centre of mass at length/2 - 2A/(k² length): where it is says what A is.
  TimeCurve sway{series.column("time"), series.column("com_x")};
  const double middle = length / 2 + wall_faces * result.number("settings/particles/spacing");
  for (double& x : sway.value) x -= middle;
  const auto [period, loss] = oscillation_of(sway);
  const double expected = wave_period(1, std::numbers::pi / length, 1);
  return {{"period", period, expected, std::abs(period / expected - 1)}, {"loss", loss, 0, std::abs(loss)}};
}

Settings iisph_and(int n, const Settings& more) {
  return with({fmt::format("time.dt={:.17g}", 0.4 / n)}, more);
}
Settings iisph(int n) { return iisph_and(n, {}); }
Settings iisph_unsmoothed(int n) { return iisph_and(n, {"particles.smoothing=1"}); }
Settings iisph_lattice(int n) { return iisph_and(n, {"fluid.jitter=0", "fluid.relax=0"}); }
Settings iisph_akinci(int n) { return iisph_and(n, {"boundary.model=akinci"}); }

/// A state equation is not at peace with the mirror wall unless viscosity takes what the wall gives.
Settings state_equation(const char* method, int n) {
  return {fmt::format("pressure.method={}", method), "boundary.model=akinci",
          fmt::format("pressure.{}.dt={:.17g}", method, 0.06 / n)};
}
Settings ssph(int n) { return state_equation("ssph", n); }
Settings wcsph(int n) { return state_equation("wcsph", n); }

}  // namespace

double wave_period(double gravity, double wave_number, double depth) {
  return 2 * std::numbers::pi / std::sqrt(gravity * wave_number * std::tanh(wave_number * depth));
}

ValidationCase wave_case() {
  return {.name = "standing_wave",
          .limits = {{"period", 0.02, 0.003}, {"loss", 0.15, 0.08}},
          .variants = {{"iisph", "IISPH, recommended", iisph},
                       {"iisph_unsmoothed", "IISPH, smoothing 1", iisph_unsmoothed},
                       {"iisph_lattice", "IISPH, from a lattice", iisph_lattice},
                       {"iisph_akinci", "IISPH, akinci wall", iisph_akinci},
                       {"ssph", "SSPH", ssph},
                       {"wcsph", "WCSPH", wcsph}},
          .series = true,
          .measure = measure};
}

}  // namespace sluice::study
