// What the validation cases with walls measure, on data whose answer is known; their scenes and references.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/scene/settings.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"
#include "studies/validation_waters.hpp"

namespace sluice::test {

using namespace study;
namespace {

/// A lattice with spacing 1 whose lower left particle is at `corner`.
std::vector<Vec2> block(Vec2 corner, int columns, int rows) {
  std::vector<Vec2> x;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) x.push_back(corner + Vec2(i, j));
  return x;
}

TEST(Bulk, ASplashAheadIsNoFront) {
  std::vector<Vec2> x = block({30, 5}, 3, 3);  // a splash, first in the order of ids
  const std::vector<Vec2> water = block({-10, -3}, 20, 10);
  x.insert(x.end(), water.begin(), water.end());
  for (const double tip : {10.9, 12.8}) x.push_back({tip, -3});  // a tongue with wide gaps
  x.push_back({14.9, -3});                                       // too far ahead
  x.push_back({-10, 25});
  const std::vector<Vec2> bulk = connected_bulk(x, 2);
  EXPECT_EQ(bulk.size(), 202u);
  EXPECT_EQ(front_of(bulk), 12.8);
  EXPECT_EQ(height_at_wall(bulk, -8.5), 6);
}

TEST(Bulk, TheHeightIsThatAtTheWall) {
  const std::vector<Vec2> steps{{0, 0}, {0.5, 3}, {1.5, 4}, {2.5, -1}};
  EXPECT_EQ(height_at_wall(steps, 1), 3);
  EXPECT_EQ(height_at_wall(steps, -1), -1) << "the water has left the wall";
}

TEST(TimeCurves, AreLinesBetweenTheirPoints) {
  const TimeCurve curve{{1, 2, 4}, {10, 20, 0}};
  EXPECT_DOUBLE_EQ(curve.at(0), 10);
  EXPECT_DOUBLE_EQ(curve.at(1.25), 12.5);
  EXPECT_DOUBLE_EQ(curve.at(3), 10);
  EXPECT_DOUBLE_EQ(curve.at(4), 0);
  EXPECT_TRUE(std::isnan(curve.at(4.001)));
  EXPECT_DOUBLE_EQ(slope_of({{0, 1, 3}, {5, 3, -1}}), -2);
}

/// A front that starts at rest, seen `delay` late.
TimeCurve front(double delay, double step, double until = 4) {
  TimeCurve curve;
  for (double t = 0; t < until; t += step) curve.add(t, 1 + std::pow(std::max(t - delay, 0.0), 2) / 3);
  return curve;
}

TEST(TimeCurves, ADelayIsFound) {
  const TimeCurve ours = front(0, 0.01), late = front(0.25, 0.3);
  EXPECT_NEAR(fitted_delay(ours, late, -0.5, 1), 0.25, 0.001);
  EXPECT_NEAR(fitted_delay(front(0.25, 0.01), front(0, 0.3, 3.5), -0.5, 1), -0.25, 0.001);
  EXPECT_LT(distance(ours, late, 0.25), 1e-4);
  EXPECT_GT(distance(ours, late), 0.05);
}

TEST(TimeCurves, TheirDistanceIsRelativeToTheLargestOfTheReference) {
  const TimeCurve reference{{0, 1, 2}, {1, 4, 2}}, ours{{0, 1, 2}, {1, 4.4, 1.8}};
  EXPECT_NEAR(distance(ours, reference), std::sqrt((0.16 + 0.04) / 3) / 4, 1e-12);
}

TEST(Oscillations, PeriodAndLossAreFound) {
  TimeCurve curve;
  constexpr double period = 2.5, loss = 0.1;
  for (double t = 0.02; t < 7; t += 0.05)
    curve.add(t, -3 * std::pow(1 - loss, t / period) * std::cos(2 * std::numbers::pi * t / period));
  const Oscillation found = oscillation_of(curve);
  EXPECT_NEAR(found.period, period, 0.001);
  EXPECT_NEAR(found.loss, loss, 0.001);
  curve.time.resize(50);  // a period: two zeros
  curve.value.resize(50);
  EXPECT_TRUE(std::isnan(oscillation_of(curve).period));
}

TEST(Oscillations, TheWaveHasTheDispersionOfWater) {
  constexpr double pi = std::numbers::pi, g = 9.81;
  EXPECT_NEAR(wave_period(g, 2 * pi / 100, 1000), 8.0035, 1e-3) << "100 m long, on deep water";
  EXPECT_NEAR(wave_period(g, 2 * pi / 1000, 1), 1000 / std::sqrt(g), 0.01) << "on shallow water";
  EXPECT_NEAR(wave_period(1, pi / 2, 1), 5.23479, 1e-5);
}

TEST(PressureOfATank, IsAveragedInBins) {
  constexpr double h = 0.1, weight = 20;
  std::vector<Vec2> x = block({0, 0}, 4, 10);
  for (Vec2& p : x) p = p * h + Vec2(7, 3 + h / 2);
  const auto moment = [&](double more, double scatter) {
    std::vector<double> pressure;
    for (const Vec2& p : x) pressure.push_back(weight * (4 - p.y) + more + scatter);
    return pressure;
  };
  PressureBins right(h, 3);
  right.add(x, moment(0, 5));
  right.add(x, moment(0, -5));  // a single moment may scatter
  EXPECT_NEAR(right.level(), 1, 1e-9);
  EXPECT_NEAR(right.error(weight), 0, 1e-9);
  PressureBins off(h, 3);
  off.add(x, moment(0.4, 0));
  EXPECT_NEAR(off.error(weight), 0.4, 1e-9);
  PressureBins steep(h, 3);  // off by 2 times the depth, which is 0.05 to 0.95
  steep.add(x, moment(0, 0));
  EXPECT_NEAR(steep.error(weight - 2), 2 * std::sqrt(0.3325), 1e-9);
}

TEST(PressureOfATank, LeavesOutWhatIsHardlyWater) {
  std::vector<Vec2> x = block({0, 0}, 4, 10);
  for (Vec2& p : x) p.y += 0.5;
  std::vector<double> pressure(x.size(), 0);
  x.push_back({0, 10.5});  // one of four, above the surface
  PressureBins bins(1, 0);
  pressure.push_back(1000);
  bins.add(x, pressure);
  EXPECT_LT(bins.error(0), 1e-9);
}

TEST(EnergyOfADam, RisesAreSeen) {
  EXPECT_DOUBLE_EQ(largest_rise({0, 1, 3, 1}, {10, 9, 8, 7}, 10, 4), 0.25);
  EXPECT_DOUBLE_EQ(largest_rise({0, 1, 2, 1}, {10, 5, 6, 6}, 10, 4), 0.5) << "after it fell";
  EXPECT_DOUBLE_EQ(largest_rise({0, 1, 2}, {10, 9, 7}, 10, 4), 0);
}

TEST(References, AreThoseOfTheExperiments) {
  const auto read = [](const char* file) { return reference_beside("validation/dam_break", file); };
  const TimeCurve front_moyce = read("martin_moyce_front.csv"), height = read("martin_moyce_height.csv"),
                  koshizuka = read("koshizuka_oka_front.csv");
  EXPECT_EQ(front_moyce.time.size(), 15u);
  EXPECT_DOUBLE_EQ(front_moyce.at(1.98), 2.33);
  EXPECT_DOUBLE_EQ(front_moyce.at(3.33), 4.11);
  EXPECT_EQ(height.time.size(), 17u);
  EXPECT_DOUBLE_EQ(height.at(2), 0.5);
  EXPECT_DOUBLE_EQ(height.at(7.4), 0.06);
  EXPECT_EQ(koshizuka.time.size(), 9u);
  EXPECT_DOUBLE_EQ(koshizuka.at(3.096), 3.624);
  for (const TimeCurve& curve : {front_moyce, height, koshizuka})
    EXPECT_TRUE(std::ranges::is_sorted(curve.time));
  EXPECT_THROW(read("nobody.csv"), InputError);
}

Samples at_start(const ValidationCase& known, const Variant& variant, int n) {
  std::vector<std::string> settings = variant.overrides(n);
  settings.insert(settings.end(),
                  {fmt::format("particles.spacing={:.17g}", known.length / n), "fluid.jitter=0"});
  return sample(load_scene(fmt::format("validation/{}", known.name), settings));
}

TEST(ScenesWithWalls, HoldAsMuchWaterAsTheySay) {
  for (const ValidationCase& known : water_cases()) {
    for (const Variant& variant : known.variants) {
      for (const int n : {20, 40, 80}) {
        SCOPED_TRACE(fmt::format("{} {} {}", known.name, variant.name, n));
        const std::vector<Vec2> x = at_start(known, variant, n).fluid;
        const double h = known.length / n, face = wall_faces * h;
        const double width = known.name == "dam_break" ? 1 : known.name == "standing_wave" ? 2 : 0.5;
        const double height = known.name == "dam_break" ? 2 : 1;
        const double area = static_cast<double>(x.size()) * h * h;
        EXPECT_NEAR(area, width * height, known.name == "standing_wave" ? 0.5 * h : 1e-9);
        EXPECT_NEAR(front_of(x) + h / 2 - face, width, 1e-9);
        double least = 1e9;
        for (const Vec2& p : x) least = std::min({least, p.x, p.y});
        EXPECT_NEAR(least - h / 2, face, 1e-9);
      }
    }
  }
}

TEST(ScenesWithWalls, TheWaveStartsUnderACosine) {
  const ValidationCase known = wave_case();
  const double h = 1.0 / 40, face = wall_faces * h;
  const std::vector<Vec2> x = at_start(known, known.variants.front(), 40).fluid;
  for (int column = 0; column < 80; ++column) {
    double top = 0;
    for (const Vec2& p : x)
      if (std::abs(p.x - (column + 3) * h) < h / 2) top = std::max(top, p.y);
    const double surface = 1 + 0.1 * std::cos(std::numbers::pi * (column + 0.5) * h / 2);
    EXPECT_NEAR(top + h / 2 - face, surface, 0.51 * h) << column;
  }
}

TEST(ScenesWithWalls, AreShippedAsTheStudyRunsThemAtForty) {
  for (const ValidationCase& known : water_cases()) {
    const std::string name = fmt::format("validation/{}", known.name);
    EXPECT_EQ(load_scene(name).spacing, known.length / 40);
    for (const char* method : {"iisph", "ssph", "wcsph"}) {
      SCOPED_TRACE(fmt::format("{} {}", name, method));
      const auto variant = std::ranges::find(known.variants, method, &Variant::name);
      ASSERT_NE(variant, known.variants.end());
      const std::vector<std::string> chosen{fmt::format("pressure.method={}", method)};
      const Scene shipped = load_scene(name, chosen), run = load_scene(name, variant->overrides(40));
      EXPECT_EQ(shipped.method, run.method);
      EXPECT_NEAR(shipped.dt, run.dt, 1e-12);
      EXPECT_EQ(settings_of(shipped)["pressure"]["iisph"], settings_of(run)["pressure"]["iisph"]);
      EXPECT_EQ(settings_of(shipped)["particles"]["smoothing"], settings_of(run)["particles"]["smoothing"]);
    }
  }
}

}  // namespace
}  // namespace sluice::test
