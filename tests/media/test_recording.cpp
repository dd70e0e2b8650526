// Recordings: every bit of a run comes back, in any order, and a file that isn't what was written is refused
// by name.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <array>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/scene/settings.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "tests/support/recorded.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

void expect_equal(const media::Moment& found, const media::Moment& written) {
  const StepReport &a = found.report, &b = written.report;
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.dt, b.dt);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.converged, b.converged);
  const Diagnostics &c = a.diagnostics, &d = b.diagnostics;
  EXPECT_EQ(c.mean_density, d.mean_density);
  EXPECT_EQ(c.mean_compression, d.mean_compression);
  EXPECT_EQ(c.max_compression, d.max_compression);
  EXPECT_EQ(c.kinetic_energy, d.kinetic_energy);
  EXPECT_EQ(c.potential_energy, d.potential_energy);
  EXPECT_EQ(c.centre_of_mass, d.centre_of_mass);
  EXPECT_EQ(c.max_speed, d.max_speed);
  EXPECT_EQ(c.cfl, d.cfl);
  EXPECT_EQ(c.wall_force, d.wall_force);
  EXPECT_EQ(c.lost, d.lost);
  EXPECT_EQ(found.seconds_per_step, written.seconds_per_step);
  EXPECT_EQ(found.state.step, written.state.step);
  EXPECT_EQ(found.state.x, written.state.x);
  EXPECT_EQ(found.state.v, written.state.v);
  EXPECT_EQ(found.state.density, written.state.density);
  EXPECT_EQ(found.state.pressure, written.state.pressure);
}

class RecordingOf : public testing::TestWithParam<Precision> {};

TEST_P(RecordingOf, EveryBitComesBackInAnyOrder) {
  const TemporaryFolder folder;
  const auto path = folder / "a.rec";
  const Recorded written(path, "breaking_dam", 12, GetParam(), {"fluid.jitter=0.1", "output.size=[120,180]"});
  const media::Recording recording(path);
  ASSERT_EQ(recording.frames(), written.moments.size());
  EXPECT_EQ(recording.precision(), GetParam());
  EXPECT_EQ(settings_of(recording.scene()), settings_of(written.scene));
  EXPECT_EQ(recording.samples().fluid, written.samples.fluid);
  EXPECT_EQ(recording.samples().boundary, written.samples.boundary);
  for (const size_t k : {13u, 0u, 12u, 5u, 6u, 1u}) {
    SCOPED_TRACE(k);
    expect_equal(recording.moment(k), written.moments[k]);
  }
  EXPECT_NE(recording.moment(3).state.x, recording.moment(4).state.x);
  EXPECT_GT(recording.moment(12).report.iterations, 0u);
  EXPECT_GT(recording.moment(12).report.diagnostics.max_speed, 0);
}

std::string precision_name(const testing::TestParamInfo<Precision>& info) {
  return info.param == Precision::double_ ? "Double" : "Float";
}
INSTANTIATE_TEST_SUITE_P(Precisions, RecordingOf, testing::Values(Precision::single_, Precision::double_),
                         precision_name);

TEST(Recording, AFrameOfTheSameStepTakesNoRoom) {
  const TemporaryFolder folder;
  const Recorded written(folder / "a.rec", "breaking_dam", 1);
  const auto size = std::filesystem::file_size(folder / "a.rec");
  media::RecordingWriter longer(folder / "b.rec", written.scene, Precision::single_, "a test");
  for (const media::Moment& moment : written.moments)
    for (int k = 0; k < 10; ++k) add(longer, moment);
  longer.commit();
  EXPECT_EQ(longer.frames(), 30u);
  EXPECT_EQ(std::filesystem::file_size(folder / "b.rec"), size + 27 * 32);
}

TEST(Recording, WithoutAFrameThereIsNoFile) {
  const TemporaryFolder folder;
  const Scene scene = load_scene("breaking_dam");
  media::RecordingWriter(folder / "a.rec", scene, Precision::single_, "a test").commit();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(Recording, IsKnownByItsFirstBytes) {
  const TemporaryFolder folder;
  const Recorded written(folder / "a.rec", "inclined_plane", 1);
  const std::string bytes = read_file(folder / "a.rec");
  for (const size_t length : {size_t{1}, size_t{10}, size_t{16}, bytes.size()}) {
    std::ofstream(folder / "b.rec", std::ios::binary) << bytes.substr(0, length);
    EXPECT_TRUE(media::is_recording(folder / "b.rec")) << length;
  }
  for (const char* other : {"", "x", "sluice recordinG", "[scene]\n"}) {
    std::ofstream(folder / "b.rec", std::ios::binary) << other;
    EXPECT_FALSE(media::is_recording(folder / "b.rec")) << other;
  }
  EXPECT_FALSE(media::is_recording(folder / "nowhere.rec"));
  EXPECT_FALSE(media::is_recording(folder.path));
}

TEST(Recording, NumbersThatAreNotFiniteAreRefused) {
  const TemporaryFolder folder;
  Recorded written(folder / "a.rec", "inclined_plane", 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int which : {0, 1, 2, 3}) {
    media::Moment moment = written.moments[1];
    const std::array<double*, 4> places{&moment.state.x[7].y, &moment.state.pressure[0], &moment.report.dt,
                                        &moment.seconds_per_step};
    *places[static_cast<size_t>(which)] = nan;
    media::RecordingWriter writer(folder / "b.rec", written.scene, Precision::single_, "a test");
    add(writer, moment);
    writer.commit();
    EXPECT_THROW(media::Recording(folder / "b.rec").moment(0), InputError) << which;
  }
}

TEST(Recording, ChangesOfTheOutputAreAppliedToItsScene) {
  const TemporaryFolder folder;
  const Recorded written(folder / "a.rec", "breaking_dam", 1, Precision::single_, {"output.colour=density"});
  const std::vector<std::string> changes{"output.size=[640,480]", "output.colour=pressure"};
  const media::Recording recording(folder / "a.rec", changes);
  EXPECT_EQ(recording.scene().image_size, glm::uvec2(640, 480));
  EXPECT_EQ(recording.scene().colour, Colour::pressure);
  EXPECT_EQ(media::Recording(folder / "a.rec").scene().colour, Colour::density);
}

/// What opening this file is answered with; the name that every refusal begins with is checked and cut off.
std::string refusal_of(const std::filesystem::path& path) {
  try {
    const media::Recording recording(path);
    for (size_t k = 0; k < recording.frames(); ++k) recording.moment(k);
  } catch (const InputError& error) {
    const std::string message = error.what(), name = path.string() + ": ";
    EXPECT_TRUE(message.starts_with(name)) << message;
    return message.substr(std::min(name.size(), message.size()));
  }
  return "accepted";
}

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The bytes with the checksum that they should have.
std::string sealed(std::string bytes) {
  const size_t place = bytes.size() - 16;
  const uint64_t checksum = XXH3_64bits(bytes.data(), place);
  bytes.replace(place, 8, reinterpret_cast<const char*>(&checksum), 8);
  return bytes;
}

class DamagedRecording : public testing::Test {
 protected:
  DamagedRecording() : written(folder / "whole.rec", "inclined_plane", 3) {
    bytes = read_file(folder / "whole.rec");
  }
  std::string refusal(const std::string& changed) {
    write(folder / "changed.rec", changed);
    return refusal_of(folder / "changed.rec");
  }

  TemporaryFolder folder;
  Recorded written;
  std::string bytes;
};

TEST_F(DamagedRecording, IsRefusedWhereverItWasCutOff) {
  ASSERT_EQ(refusal(bytes), "accepted");
  for (size_t length = 1; length < bytes.size(); length += length < 3000 ? 1 : 997) {
    ASSERT_TRUE(refusal(bytes.substr(0, length)).starts_with("found a recording that was cut off or altered"))
        << length;
  }
  EXPECT_TRUE(refusal(bytes + '\0').starts_with("found a recording that was cut off or altered"));
}

TEST_F(DamagedRecording, IsRefusedWhereverAByteWasAltered) {
  for (size_t place = 0; place < bytes.size(); place += place < 40 || place + 200 > bytes.size() ? 1 : 61) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ 4);
    ASSERT_NE(refusal(changed), "accepted") << place;
  }
}

TEST_F(DamagedRecording, OfALaterFormatNamesIt) {
  std::string later = bytes;
  later[16] = 3;  // behind the 16 bytes that say what the file is
  EXPECT_EQ(refusal(later),
            "found a recording of format 3, expected format 2; use the version of Sluice that made it");
}

TEST_F(DamagedRecording, AnotherKindOfFileIsNamedSo) {
  const std::string other = "found another kind of file, expected a recording made by `sluice run --record`";
  EXPECT_EQ(refusal(""),
            "found a recording that was cut off or altered, expected one as `sluice run --record` "
            "wrote it; copy it again or record the run once more");
  EXPECT_EQ(refusal("[scene]\ntitle = \"A scene\"\n"), other);
  EXPECT_EQ(refusal_of(folder / "nowhere.rec"), "found no such file, expected a recording");
  EXPECT_EQ(refusal_of(folder.path), "found a folder, expected a recording");
}

TEST_F(DamagedRecording, ASceneInsideThatThisVersionDoesNotKnowIsNamed) {
  Scene strange = written.scene;
  strange.record.text.replace(strange.record.text.find("spacing"), 7, "spacung");
  media::RecordingWriter writer(folder / "strange.rec", strange, Precision::single_, "a test");
  add(writer, written.moments[0]);
  writer.commit();
  const std::string message = refusal_of(folder / "strange.rec");
  EXPECT_TRUE(message.starts_with("found a scene in it that this version can't read: ")) << message;
  EXPECT_NE(message.find("particles.spacung: found an unknown key"), std::string::npos) << message;
}

/// Whoever works out the checksum anew still can't make the program read beyond the file.
TEST_F(DamagedRecording, NumbersThatLieAreRefusedEvenWithTheRightChecksum) {
  const size_t tail = bytes.size() - 32, index = tail - 5 * 32;
  const uint64_t huge = uint64_t{1} << 60;
  for (const size_t place : {size_t{20}, index, index + 8, index + 32, index + 40, tail, tail + 8}) {
    std::string changed = bytes;
    changed.replace(place, place == 20 ? 4 : 8, reinterpret_cast<const char*>(&huge), place == 20 ? 4 : 8);
    if (place == 20) changed[23] = '\x7f';  // the size of the header
    EXPECT_TRUE(refusal(sealed(changed)).starts_with("found a recording that was cut off or altered"))
        << place;
  }
  EXPECT_EQ(refusal(sealed(bytes)), "accepted") << "the checksum is worked out as the writer does";
}

TEST_F(DamagedRecording, APrecisionThatThereIsNotIsRefused) {
  const std::string precision = "\"precision\": \"float\"";
  std::string changed = bytes;
  changed.replace(changed.find(precision), precision.size(), "\"precision\": \"fl0at\"");
  EXPECT_TRUE(refusal(sealed(changed)).starts_with("found a recording that was cut off or altered"));
}

/// The message stays one line whatever the scene's name is.
TEST_F(DamagedRecording, ALineBreakInTheNameOfTheSceneStaysOutOfTheMessage) {
  Scene strange = written.scene;
  strange.file = "a\nb.toml";
  strange.record.text = "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1";
  media::RecordingWriter writer(folder / "strange.rec", strange, Precision::single_, "a test");
  add(writer, written.moments[0]);
  writer.commit();
  EXPECT_NE(refusal_of(folder / "strange.rec").find(": a b.toml:1:32: "), std::string::npos)
      << refusal_of(folder / "strange.rec");
}

TEST_F(DamagedRecording, OneThatChangesWhileItIsOpenIsRefusedToo) {
  write(folder / "open.rec", bytes);
  const media::Recording recording(folder / "open.rec");
  EXPECT_NO_THROW(recording.moment(2));
  std::string changed = bytes;
  for (size_t place = 2000; place + 500 < changed.size(); ++place) changed[place] = 0;
  write(folder / "open.rec", changed);
  EXPECT_THROW(recording.moment(2), InputError);
}

}  // namespace
}  // namespace sluice::test
