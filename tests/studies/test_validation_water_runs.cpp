// The validation cases with walls, measured on runs that are made up and on short ones that are not.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/scene/settings.hpp"
#include "media/recording.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"
#include "studies/validation_waters.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

using namespace study;
namespace {

/// The files of a point, written by hand.
class MadeUpRun {
 public:
  MadeUpRun(const std::string& name, double spacing)
      : point_{.name = name, .scene = fmt::format("validation/{}", name)},
        overrides_{fmt::format("particles.spacing={}", spacing), "fluid.jitter=0"},
        scene(load_scene(point_.scene, overrides_)),
        start(sample(scene).fluid),
        files_(folder_.path, point_) {
    std::filesystem::create_directories(folder_ / "runs");
  }

  /// `header` and rows of numbers, as a series.
  void write_series(const std::string& header, const std::vector<std::vector<double>>& rows) const {
    std::ofstream series(files_.series);
    series << header << '\n';
    for (const std::vector<double>& row : rows) series << fmt::format("{:.12g}\n", fmt::join(row, ","));
  }

  media::RecordingWriter recording() const {
    return media::RecordingWriter(files_.recording, scene, Precision::double_, "a test");
  }

  Result result(double time) const {
    return {point_, files_, {{"settings", settings_of(scene)}, {"time", time}, {"fluid", start.size()}}};
  }

 private:
  TemporaryFolder folder_;
  Point point_;
  std::vector<std::string> overrides_;

 public:
  const Scene scene;
  const std::vector<Vec2> start;

 private:
  PointFiles files_;
};

/// A frame of water that does not move. Its step makes it another than the one before.
void add_frame(media::RecordingWriter& writer, uint64_t step, double time, const std::vector<Vec2>& x,
               const std::vector<double>& pressure) {
  StepReport report;
  report.step = step;
  report.time = time;
  writer.add(report, 0,
             {x, std::vector<Vec2>(x.size(), Vec2(0)), std::vector<double>(x.size(), 1), pressure, step});
}

TEST(MadeUpRuns, OfATank) {
  const MadeUpRun run("hydrostatic_tank", 0.1);
  ASSERT_EQ(run.start.size(), 50u);
  media::RecordingWriter writer = run.recording();
  for (uint64_t step = 0; step <= 10; ++step) {
    std::vector<double> pressure;  // from the middle of the run on it is off by 2 % of that at the floor
    for (const Vec2& x : run.start) pressure.push_back(step < 5 ? 7 : 1.25 - x.y + 0.02);
    add_frame(writer, step, static_cast<double>(step), run.start, pressure);
  }
  writer.commit();
  std::vector<std::vector<double>> rows;
  for (double t = 0.5; t <= 10; t += 0.5)
    rows.push_back({t, t < 5 ? 7 : 0.75 + 0.001 * t, t < 5 ? -7 : -0.49});
  run.write_series("time,com_y,wall_force_y", rows);

  const std::vector<Measure> found = tank_case().measure(run.result(10));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].quantity, "pressure");
  EXPECT_NEAR(found[0].error, 0.02, 1e-9);
  EXPECT_EQ(found[1].quantity, "drift");
  EXPECT_NEAR(found[1].error, 2 * 0.001 * 5, 1e-9);
  EXPECT_EQ(found[2].quantity, "force");
  EXPECT_NEAR(found[2].error, 0.02, 1e-9);
}

/// Water along floor and wall, as far and as high as it should be; the rest in the corner, and a splash.
std::vector<Vec2> angle(size_t count, double h, double front, double height) {
  const double face = wall_faces * h;
  std::vector<Vec2> x{{17, face + h}};
  for (double from = face + h / 2; from < face + front - h / 2; from += h) x.push_back({from, face + h / 2});
  for (double from = face + h / 2; from < face + height - h / 2; from += h) x.push_back({face + h / 2, from});
  x.push_back({face + front - h / 2, face + h / 2});
  x.push_back({face + h / 2, face + height - h / 2});
  x.resize(std::max(count, x.size()), {face + h / 2, face + h / 2});
  return x;
}

TEST(MadeUpRuns, OfADam) {
  const MadeUpRun run("dam_break", 0.05);
  ASSERT_EQ(run.start.size(), 800u);
  const TimeCurve front = reference_beside("validation/dam_break", "martin_moyce_front.csv"),
                  height = reference_beside("validation/dam_break", "martin_moyce_height.csv");
  const std::vector<double> pressure(run.start.size(), 0);
  media::RecordingWriter writer = run.recording();
  add_frame(writer, 0, 0, run.start, pressure);
  for (uint64_t step = 1; step <= 375; ++step) {
    const double tau = 0.02 * static_cast<double>(step), late = tau * std::sqrt(2.0) + 0.25;
    const double z = late < 3.33 ? front.at(late) : 4.11 + (late - 3.33);
    add_frame(writer, step, tau, angle(800, 0.05, z, 2 * (height.at(std::min(tau, 7.4)) + 0.05)), pressure);
  }
  writer.commit();
  // The column holds 2, with its middle 1 above the floor, which is at 0.125.
  run.write_series("time,kinetic_energy,potential_energy", {{1, 0, 2.25}, {2, 0.12, 2.15}, {3, 1, 1}});

  std::map<std::string, Measure> found;
  for (const Measure& measure : dam_case().measure(run.result(7.5))) found[measure.quantity] = measure;
  EXPECT_NEAR(found.at("height").error, 0.05 / 0.94, 1e-3);
  EXPECT_NEAR(found.at("front_offset").ours, 0.25, 0.01);
  EXPECT_LT(found.at("front_offset").error, 0.003);
  EXPECT_NEAR(found.at("front").ours, 4.36, 0.01);
  EXPECT_GT(found.at("front").error, 0.05);
  EXPECT_GT(found.at("front_koshizuka").error, 0.05);
  EXPECT_NEAR(found.at("energy").error, 0.01, 1e-9);
}

TEST(MadeUpRuns, OfAWave) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "runs");
  const Point point{.name = "wave", .scene = "validation/standing_wave"};
  const PointFiles files(folder.path, point);
  std::ofstream series(files.series);
  series << "time,com_x\n";
  const double period = 1.02 * 5.23479;  // too slow by 2 %
  for (double t = 0.02; t < 12.5; t += 0.02)
    series << fmt::format(
        "{},{:.9f}\n", t,
        1.125 - 0.04 * std::pow(0.8, t / period) * std::cos(2 * std::numbers::pi * t / period));
  series.close();
  const nlohmann::json summary{{"settings", {{"particles", {{"spacing", 0.05}}}}}};
  const std::vector<Measure> found = wave_case().measure({point, files, summary});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].quantity, "period");
  EXPECT_NEAR(found[0].error, 0.02, 1e-4);
  EXPECT_EQ(found[1].quantity, "loss");
  EXPECT_NEAR(found[1].error, 0.2, 1e-3);
}

TEST(ValidationWithWalls, TheCoarseRunsKeepTheLimits) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"study", "validate", "--only", "_iisph_20_double", "--out", "out"}, folder.path);
  std::map<std::string, double> errors;
  for (const Result& run : results_in(folder / "out", validation_points()).whole) {
    const std::string& name = run.point.fact("case");
    const auto known = std::ranges::find(validation_cases(), name, &ValidationCase::name);
    for (const Measure& measure : known->measure(run))
      errors[fmt::format("{} {}", name, measure.quantity)] = measure.error;
  }
  for (const ValidationCase& known : water_cases()) {
    for (const Limit& limit : known.limits) {
      const std::string key = fmt::format("{} {}", known.name, limit.quantity);
      ASSERT_TRUE(errors.contains(key)) << key << '\n' << result.err;
      EXPECT_LE(errors[key], limit.at_40) << key;
    }
  }
  EXPECT_LT(errors["hydrostatic_tank force"], 0.01);
}

}  // namespace
}  // namespace sluice::test
