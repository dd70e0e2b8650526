// The study `validate` without walls: exact motions, what is measured of a run, and that its scenes are those
// of the references.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/scene/settings.hpp"
#include "studies/validation_drops.hpp"
#include "tests/support/recorded.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

std::map<std::string, Measure> by_name(const std::vector<Measure>& measures) {
  std::map<std::string, Measure> found;
  for (const Measure& measure : measures) found[measure.quantity] = measure;
  return found;
}

/// Frames of a drop that moves as it should, but for what `change` does to it.
std::vector<Blob> frames_of(const IdealDrop& drop, double gap, int count, const auto& change) {
  std::vector<Blob> blobs;
  for (int k = 0; k < count; ++k) {
    Blob blob{.time = k * gap};
    const IdealDrop::State state = drop.at(blob.time);
    const double squares = state.a * state.a + state.b * state.b;
    blob.semi_axes = {state.a, state.b};
    blob.kinetic = state.rate * state.rate * squares / 8;
    blob.distance_squared = squares / 4;
    change(blob);
    blobs.push_back(blob);
  }
  return blobs;
}

std::map<std::string, Measure> oscillation(const auto& change) {
  return by_name(oscillation_measures(oscillating_drop, frames_of(oscillating_drop, 0.125, 41, change)));
}

TEST(IdealDrop, HasThePublishedPeriod) {
  const double period = oscillating_drop.period();
  EXPECT_NEAR(period, 4.567375, 2e-6);  // as published, rounded
  const IdealDrop::State state = oscillating_drop.at(period);
  EXPECT_NEAR(state.a, 1, 1e-8);
  EXPECT_NEAR(state.b, 1, 1e-8);
  EXPECT_NEAR(state.rate, 0.5, 1e-8);
  const IdealDrop inward{.radius = 2, .rate = -0.5, .omega_squared = 1};
  EXPECT_NEAR(inward.period(), period, 1e-8);
}

TEST(IdealDrop, KeepsAreaAndEnergy) {
  for (const auto& [drop, end] : {std::pair{oscillating_drop, 9.0}, {elliptic_drop, 0.0076}}) {
    const double energy = (drop.rate * drop.rate + drop.omega_squared) * 2;
    for (int k = 0; k <= 10; ++k) {
      const IdealDrop::State state = drop.at(end * k / 10);
      EXPECT_NEAR(state.a * state.b, 1, 1e-9);
      EXPECT_NEAR((state.rate * state.rate + drop.omega_squared) * (state.a * state.a + state.b * state.b),
                  energy, 1e-9 * energy);
    }
  }
}

TEST(IdealDrop, MovesAsTheTablesBesideTheScenesSay) {
  for (const auto& [name, drop] :
       {std::pair{"oscillating_drop", oscillating_drop}, {"elliptic_drop", elliptic_drop}}) {
    const CsvTable table = read_csv(std::filesystem::path(SLUICE_SOURCE_DIR) / "scenes" / "validation" /
                                    (std::string(name) + ".csv"));
    ASSERT_GE(table.size(), 20u);
    for (size_t row = 0; row < table.size(); ++row) {
      const IdealDrop::State state = drop.at(table.at(row, "t"));
      EXPECT_NEAR(state.a, table.at(row, "a"), 2e-10) << name << " " << row;
      EXPECT_NEAR(state.b, table.at(row, "b"), 2e-10 * state.b) << name << " " << row;
    }
  }
}

TEST(Blob, IsWhatItsParticlesAreAsAWhole) {
  Snapshot state;
  state.x = {{4, 2}, {2, 2}, {3, 4}, {3, 0}};
  state.v = {{1, 0}, {1, 0}, {1, 2}, {1, 0}};
  const Blob blob = blob_of(7, state);
  EXPECT_EQ(blob.time, 7);
  EXPECT_EQ(blob.centre, Vec2(3, 2));
  EXPECT_EQ(blob.velocity, Vec2(1, 0.5));
  EXPECT_NEAR(blob.semi_axes.x, std::numbers::sqrt2, 1e-15);  // mean square distance 1/2
  EXPECT_NEAR(blob.semi_axes.y, 2 * std::numbers::sqrt2, 1e-15);
  EXPECT_EQ(blob.kinetic, 1);
  EXPECT_EQ(blob.distance_squared, (20 + 8 + 25 + 9) / 4.0);
  EXPECT_EQ(blob.angular_momentum, (-2 - 2 + 2 + 0) / 4.0);
}

TEST(Blob, OfAFullDiscHasItsRadius) {
  const auto start_of = [](std::vector<std::string> overrides) {
    return blob_of(0, Simulation(shipped("validation/oscillating_drop", overrides)).simulator->snapshot());
  };
  for (const Blob& blob : {start_of({}), start_of({"fluid.jitter=0", "fluid.relax=0"})}) {
    EXPECT_NEAR(blob.semi_axes.x, 1, 2e-3);
    EXPECT_NEAR(blob.semi_axes.y, 1, 2e-3);
    EXPECT_NEAR(blob.kinetic, 0.5 * 0.5 / 4, 2e-4);
  }
}

TEST(Blob, IsReadFromEveryFrameOfARecordingOnce) {
  const TemporaryFolder folder;
  const Recorded written(folder / "run.rec", "validation/free_fall", 3, Precision::double_,
                         {"particles.spacing=0.1"});
  const std::vector<Blob> blobs = blobs_of(folder / "run.rec");
  ASSERT_EQ(blobs.size(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(blobs[k].time, written.moments[k].report.time);
    EXPECT_EQ(blobs[k].centre, blob_of(0, written.moments[k].state).centre);
  }
}

TEST(Blob, CubicsAreInterpolatedExactly) {
  const auto f = [](double t) { return (t - 2.3) * (t * t + 1); };
  const std::vector<double> times = {0, 0.5, 1.5, 2, 3, 3.25, 4};
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  for (const double t : {0.0, 0.2, 1.0, 2.9, 3.1, 3.9, 4.0})
    EXPECT_NEAR(value_at(t, times, values), f(t), 1e-12);
  EXPECT_NEAR(zero_after(3, times, values), 2.3, 1e-12);
  for (double& value : values) value = -value;
  EXPECT_NEAR(zero_after(3, times, values), 2.3, 1e-12);
}

TEST(DropMeasures, OfTheExactMotionAreNothing) {
  const auto swinging = oscillation([](Blob&) {});
  ASSERT_EQ(swinging.size(), 4u);
  for (const auto& [name, measure] : swinging) EXPECT_LT(measure.error, 5e-6) << name;
  for (const Measure& measure :
       elongation_measures(elliptic_drop, frames_of(elliptic_drop, 4e-4, 20, [](Blob&) {})))
    EXPECT_LT(measure.error, 1e-9) << measure.quantity;
}

TEST(DropMeasures, SeeASlowDrop) {
  const auto slow = oscillation([](Blob& blob) {
    const IdealDrop::State state = oscillating_drop.at(blob.time / 1.01);
    blob.semi_axes = {state.a, state.b};
  });
  EXPECT_NEAR(slow.at("period").ours, 4.567375 * 1.01, 1e-4);
  EXPECT_NEAR(slow.at("period").error, 0.01, 2e-5);
  EXPECT_NEAR(slow.at("semi-axes after a period").error, 0.5 * 0.01 * 4.567, 1e-3);
  EXPECT_GT(slow.at("semi-axes, largest error").error, slow.at("semi-axes after a period").error * 0.9);
}

TEST(DropMeasures, SeeAWrongShape) {
  const auto at_one_frame = oscillation([](Blob& blob) {
    if (blob.time == 1.125) blob.semi_axes.y -= 0.02;
  });
  EXPECT_NEAR(at_one_frame.at("semi-axes, largest error").error, 0.02, 1e-9);
  EXPECT_LT(at_one_frame.at("semi-axes after a period").error, 1e-9);
  const auto too_long = oscillation([](Blob& blob) { blob.semi_axes.x += 0.03; });
  EXPECT_NEAR(too_long.at("semi-axes after a period").error, 0.03, 1e-9);
  const auto too_thin = oscillation([](Blob& blob) { blob.semi_axes.y -= 0.03; });
  EXPECT_NEAR(too_thin.at("semi-axes after a period").error, 0.03, 1e-9);
  // What comes after the period is not looked at.
  const auto later = oscillation([](Blob& blob) {
    if (blob.time > 4.9) blob.semi_axes.x += 1;
  });
  EXPECT_LT(later.at("semi-axes, largest error").error, 1e-9);
}

TEST(DropMeasures, SeeLostEnergy) {
  // Over its rest, the drop has the 1/16 that it moves with; a period takes a tenth of that.
  const auto lossy = oscillation([](Blob& blob) { blob.kinetic -= 0.1 / 16 * blob.time / 4.567375; });
  EXPECT_NEAR(lossy.at("energy per period").ours, 0.1, 1e-6);
  EXPECT_NEAR(lossy.at("energy per period").error, 0.1, 1e-6);
  const auto gaining =
      oscillation([](Blob& blob) { blob.distance_squared += 2 * 0.1 / 16 * blob.time / 4.567375; });
  EXPECT_NEAR(gaining.at("energy per period").ours, -0.1, 1e-6);
  EXPECT_NEAR(gaining.at("energy per period").error, 0.1, 1e-6);
}

TEST(DropMeasures, OfADropThatNeverTurnsHaveNoPeriod) {
  const auto stuck = oscillation([](Blob& blob) { blob.semi_axes = {1.1, 0.9}; });
  EXPECT_TRUE(std::isnan(stuck.at("period").error));
}

TEST(DropMeasures, ElongationIsTheWorstFrameOfEitherAxis) {
  const auto found =
      by_name(elongation_measures(elliptic_drop, frames_of(elliptic_drop, 4e-4, 20, [](Blob& blob) {
                                    if (std::abs(blob.time - 4e-3) < 1e-9) blob.semi_axes *= Vec2(0.97, 0.99);
                                  })));
  const IdealDrop::State then = elliptic_drop.at(4e-3);
  EXPECT_NEAR(found.at("minor semi-axis").error, 0.03, 1e-9);
  EXPECT_NEAR(found.at("minor semi-axis").reference, then.a, 1e-9);
  EXPECT_NEAR(found.at("major semi-axis").error, 0.01, 1e-9);
  EXPECT_NEAR(found.at("major semi-axis").ours, 0.99 * then.b, 1e-9);
}

TEST(DropMeasures, TheMajorSemiAxisIsTheLongerOne) {
  const IdealDrop lying{.radius = 1, .rate = 100, .omega_squared = 0};
  const auto found = by_name(elongation_measures(lying, frames_of(lying, 4e-4, 20, [](Blob& blob) {
                                                   blob.semi_axes.x *= 1.01;
                                                   blob.semi_axes.y *= 1.03;
                                                 })));
  EXPECT_NEAR(found.at("major semi-axis").error, 0.01, 1e-9);
  EXPECT_NEAR(found.at("minor semi-axis").error, 0.03, 1e-9);
}

TEST(MotionMeasures, CompareWithWhatTheStepsAddUpTo) {
  const FreeMotion motion{.velocity = {3, 0}, .gravity = {0, -8}, .dt = 0.25};
  std::vector<Blob> blobs(5);
  Vec2 x{1, 1}, v = motion.velocity;
  for (size_t k = 0; k < blobs.size(); ++k) {
    blobs[k].time = 0.25 * static_cast<double>(k);
    blobs[k].centre = x;
    blobs[k].velocity = v;
    v += motion.dt * motion.gravity;
    x += motion.dt * v;
  }
  auto found = by_name(motion_measures(motion, blobs));
  EXPECT_EQ(found.at("centre of mass").error, 0);
  EXPECT_EQ(found.at("momentum").error, 0);
  EXPECT_NEAR(found.at("fall").error, 0.25, 1e-15);  // dt over the time
  blobs[2].centre.x += 0.1;
  blobs[3].velocity.y -= 0.1;
  found = by_name(motion_measures(motion, blobs));
  EXPECT_NEAR(found.at("centre of mass").error, 0.1 / std::hypot(3, 5), 1e-15);
  EXPECT_NEAR(found.at("momentum").error, 0.1 / std::hypot(3, 8), 1e-15);
  EXPECT_EQ(by_name(motion_measures({.velocity = {3, 0}, .dt = 0.25}, blobs)).count("fall"), 0u);
}

TEST(MotionMeasures, RotationIsTheLargestChange) {
  std::vector<Blob> blobs(3);
  blobs[0].angular_momentum = 0.5;
  blobs[1].angular_momentum = 0.49;
  blobs[2].angular_momentum = 0.505;
  EXPECT_NEAR(rotation_measures(blobs).front().error, 0.02, 1e-15);
}

TEST(DropCases, ScenesAreThoseOfTheReferences) {
  const Scene swinging = shipped("validation/oscillating_drop"), drawn = shipped("validation/elliptic_drop");
  for (const auto& [scene, drop] : {std::pair{&swinging, oscillating_drop}, {&drawn, elliptic_drop}}) {
    const Disc& disc = std::get<Disc>(scene->fluid.at(0).geometry);
    EXPECT_EQ(disc.centre, Vec2(0, 0));
    EXPECT_EQ(disc.radius, drop.radius);
    EXPECT_EQ(scene->central_force, drop.omega_squared);
    EXPECT_EQ(scene->fluid[0].velocity_gradient, glm::dmat2(drop.rate, 0, 0, -drop.rate));
    EXPECT_EQ(scene->gravity, Vec2(0, 0));
  }
  EXPECT_GT(swinging.duration, 1.05 * oscillating_drop.period());
  EXPECT_EQ(shipped("validation/uniform_motion").fluid.at(0).velocity, Vec2(1, 0.5));
  EXPECT_EQ(shipped("validation/free_fall").gravity, Vec2(0, -9.81));
}

TEST(DropCases, AllRunTheirMethodAndStepsShrinkWithTheSpacing) {
  for (const ValidationCase& known : drop_cases()) {
    for (const Variant& variant : known.variants) {
      std::map<int, double> steps;
      for (const int n : {20, 40, 80}) {
        const Scene scene = shipped("validation/" + known.name, variant.overrides(n));
        const std::string method = variant.name.substr(0, variant.name.find('_'));
        EXPECT_EQ(settings_of(scene)["pressure"]["method"], method);
        EXPECT_EQ(scene.smoothing, variant.name.ends_with("_smoothed") ? 1.2 : 1.0);
        EXPECT_EQ(variant.name.ends_with("_lattice"), scene.jitter == 0);
        steps[n] = scene.dt;
      }
      EXPECT_NEAR(steps[20] / steps[80], 4, 1e-12) << known.name << " " << variant.name;
    }
  }
}

/// The error of a quantity, by running the study on one point.
double error_of(const std::string& point, const std::string& quantity) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"study", "validate", "--out", "out", "--only", point}, folder.path);
  EXPECT_TRUE(result.err.find(point + ": done") != std::string::npos) << result.err;
  const CsvTable table = read_csv(folder.path / "out" / "validate.csv");
  for (size_t row = 0; row < table.size(); ++row)
    if (table.text(row, "quantity") == quantity) return table.at(row, "error");
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(DropCases, ACoarseDropIsDrawnOutAsItShouldBe) {
  EXPECT_LT(error_of("elliptic_drop_iisph_20_double", "major semi-axis"), 0.01);
}

TEST(DropCases, FreeFallIsExactInDoubleAndRoundedInFloat) {
  EXPECT_LT(error_of("free_fall_ssph_20_double", "centre of mass"), 1e-12);
  const double rounded = error_of("free_fall_ssph_20_float", "centre of mass");
  EXPECT_LT(rounded, 1e-4);
  EXPECT_GT(rounded, 1e-9);
}

}  // namespace
}  // namespace sluice::test
