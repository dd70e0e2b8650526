// Checkpoints: every bit comes back, and a file that isn't what was written is refused by name.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/output/checkpoint.hpp"
#include "core/scene/settings.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/recorded.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"
#include "tests/support/synced.hpp"

namespace sluice::test {
namespace {

/// Few particles, so that every byte of the file can be tried.
const std::vector<std::string> small{"particles.spacing=40", "fluid.jitter=0.1"};

/// A checkpoint made through the library, and what went into it.
struct Saved {
  Scene scene;
  SimulationState state;
  RunCounts counts;

  Saved(const std::filesystem::path& path, Precision precision,
        const std::vector<std::string>& overrides = small)
      : scene(shipped("breaking_dam", overrides)) {
    Simulation simulation(scene, precision);
    RunStatistics statistics;
    for (const StepReport& report : simulation.run(5)) statistics.add(report);
    state = simulation.simulator->state();
    counts = statistics.counts();
    counts.lost = 3;
    CheckpointWriter(path, scene, precision, "a test").write(state, counts);
  }
};

void expect_equal(const SimulationState& a, const SimulationState& b) {
  EXPECT_EQ(a.clock.steps, b.clock.steps);
  EXPECT_EQ(a.clock.time(), b.clock.time());
  EXPECT_EQ(a.clock.dt, b.clock.dt);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.pressure, b.pressure);
}

TEST(Checkpoint, EveryBitComesBack) {
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const TemporaryFolder folder;
    const Saved saved(folder / "a.ckp", precision);
    const Checkpoint found = read_checkpoint(folder / "a.ckp");
    EXPECT_EQ(found.precision, precision);
    EXPECT_EQ(settings_of(found.scene), settings_of(saved.scene));
    EXPECT_EQ(found.scene.record.overrides, saved.scene.record.overrides);
    EXPECT_EQ(found.scene.name, "breaking_dam");
    EXPECT_EQ(found.state.clock.steps, 5u);
    EXPECT_GT(found.state.v[3].y, -100);
    EXPECT_NE(found.state.v[3].y, 0);
    expect_equal(found.state, saved.state);
    EXPECT_EQ(found.state.diagnostics.kinetic_energy, saved.state.diagnostics.kinetic_energy);
    EXPECT_EQ(found.state.diagnostics.wall_force, saved.state.diagnostics.wall_force);
    EXPECT_GT(found.state.diagnostics.max_speed_change, 0);
    EXPECT_EQ(found.state.diagnostics.lost, 3u);
    EXPECT_EQ(found.counts.dt_min, 0.04);
    EXPECT_EQ(found.counts.dt_max, 0.04);
    EXPECT_EQ(found.counts.steps, 5u);
    EXPECT_EQ(found.counts.iterations, saved.counts.iterations);
    EXPECT_EQ(found.counts.iterations_max, saved.counts.iterations_max);
    EXPECT_EQ(found.counts.not_converged, saved.counts.not_converged);
    EXPECT_EQ(found.counts.lost, 3u);
    EXPECT_EQ(found.counts.compression_sum, saved.counts.compression_sum);
    EXPECT_EQ(found.counts.compression_max, saved.counts.compression_max);
    EXPECT_EQ(found.counts.cfl_max, saved.counts.cfl_max);
  }
}

TEST(Checkpoint, OneTakesThePlaceOfTheLast) {
  const TemporaryFolder folder;
  Saved saved(folder / "a.ckp", Precision::double_);
  CheckpointWriter writer(folder / "a.ckp", saved.scene, Precision::double_, "a test");
  for (const double x : {1.0, 2.0, 3.0}) {
    saved.state.x[0].x = x;
    writer.write(saved.state, saved.counts);
    expect_equal(read_checkpoint(folder / "a.ckp").state, saved.state);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

TEST(Checkpoint, IsOnTheDiskBeforeItTakesThePlace) {
  const TemporaryFolder folder;
  const SyncListener listener(folder / "a.ckp");
  const Saved saved(folder / "a.ckp", Precision::single_);
  ASSERT_EQ(listener.heard.size(), 2u) << "the file, then the folder";
  EXPECT_FALSE(listener.heard[0].named);
  EXPECT_TRUE(listener.heard[1].named);
}

TEST(Checkpoint, AWriterThatWritesNothingLeavesWhatWasThere) {
  const TemporaryFolder folder;
  const Saved saved(folder / "a.ckp", Precision::single_);
  { CheckpointWriter(folder / "a.ckp", saved.scene, Precision::double_, "a test"); }
  EXPECT_EQ(read_checkpoint(folder / "a.ckp").precision, Precision::single_);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

/// What opening this file is answered with; the name that every refusal begins with is checked and cut off.
std::string refusal_of(const std::filesystem::path& path) {
  try {
    read_checkpoint(path);
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

/// With the checksum that the writer would give it.
std::string resealed(std::string bytes) {
  const size_t end = bytes.size() - 8;
  const uint64_t checksum = XXH3_64bits(bytes.data(), end);
  return bytes.replace(end, 8, reinterpret_cast<const char*>(&checksum), 8);
}

class DamagedCheckpoint : public testing::Test {
 protected:
  DamagedCheckpoint() : saved(folder / "whole.ckp", Precision::single_) {
    bytes = read_file(folder / "whole.ckp");
    facts = bytes.size() - 8 - 24 * saved.state.x.size() - 224;
  }
  std::string refusal(const std::string& changed) {
    write(folder / "changed.ckp", changed);
    return refusal_of(folder / "changed.ckp");
  }
  template <class T>
  std::string with(size_t place, T value) {
    std::string changed = bytes;
    return resealed(
        changed.replace(place, sizeof value, reinterpret_cast<const char*>(&value), sizeof value));
  }

  /// Whether a place is near an end of the file, of its header or of its facts.
  bool near_an_end(size_t place) const {
    return place < 40 || (place + 20 > facts && place < facts + 244) || place + 20 > bytes.size();
  }

  const std::string altered = "found a checkpoint that was cut off or altered";
  TemporaryFolder folder;
  Saved saved;
  std::string bytes;
  size_t facts = 0;  // where they begin
};

TEST_F(DamagedCheckpoint, IsRefusedWhereverItWasCutOff) {
  ASSERT_EQ(refusal(bytes), "accepted");
  ASSERT_LT(bytes.size(), 5000u);
  for (size_t length = 0; length < bytes.size(); length += near_an_end(length) ? 1 : 11)
    ASSERT_TRUE(refusal(bytes.substr(0, length)).starts_with(altered)) << length;
  EXPECT_TRUE(refusal(bytes + '\0').starts_with(altered));
}

TEST_F(DamagedCheckpoint, IsRefusedWhereverAByteWasAltered) {
  for (size_t place = 0; place < bytes.size(); place += near_an_end(place) ? 1 : 7) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
    ASSERT_NE(refusal(changed), "accepted") << place;
  }
}

TEST_F(DamagedCheckpoint, OfALaterFormatNamesIt) {
  std::string later = bytes;
  later[17] = 2;  // behind the 17 bytes that say what the file is
  EXPECT_EQ(refusal(later),
            "found a checkpoint of format 2, expected format 1; use the version of Sluice that made it");
}

TEST_F(DamagedCheckpoint, AnotherKindOfFileIsNamedSo) {
  const std::string other =
      "found another kind of file, expected a checkpoint made by `sluice run --checkpoint`";
  EXPECT_EQ(refusal("[scene]\ntitle = \"A scene\"\n"), other);
  EXPECT_EQ(refusal("\x89PNG\r\n\x1a\n and more of a picture"), other);
  EXPECT_TRUE(refusal("").starts_with(altered));
  const Recorded recorded(folder / "a.rec", "inclined_plane", 1);
  EXPECT_EQ(refusal_of(folder / "a.rec"), other);
  EXPECT_EQ(refusal_of(folder / "nowhere.ckp"), "found no such file, expected a checkpoint");
  EXPECT_EQ(refusal_of(folder.path), "found a folder, expected a checkpoint");
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal_of(pipe), "found a file that can't be read, expected a checkpoint")
      << "and it did not wait";
  EXPECT_EQ(message_of<InputError>([&] { media::Recording(folder / "whole.ckp"); }),
            (folder / "whole.ckp").string() +
                ": found another kind of file, expected a recording made by `sluice run --record`");
}

/// Whoever works out the checksum anew can't make the program take memory for what is not there, or run on
/// with numbers that no run has.
TEST_F(DamagedCheckpoint, NumbersThatLieAreRefusedEvenWithTheRightChecksum) {
  ASSERT_EQ(refusal(resealed(bytes)), "accepted");
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  for (const uint32_t size : {0u, 1u, 0x7fffffffu, 0xffffffffu})
    EXPECT_TRUE(refusal(with(21, size)).starts_with(altered)) << size;
  const uint64_t n = saved.state.x.size();
  for (const uint64_t count :
       {uint64_t{0}, n - 1, n + 1, n + (uint64_t{1} << 61), uint64_t{1} << 60, ~uint64_t{0} / 24 + 1})
    EXPECT_TRUE(refusal(with(facts, count)).starts_with(altered)) << count;
  for (const uint64_t steps : {uint64_t{4}, uint64_t{1} << 60}) {
    EXPECT_TRUE(refusal(with(facts + 8, steps)).starts_with(altered)) << steps;   // not that of the counts
    EXPECT_TRUE(refusal(with(facts + 48, steps)).starts_with(altered)) << steps;  // the other way round
  }
  EXPECT_TRUE(refusal(with(facts + 16, uint64_t{6})).starts_with(altered))
      << "dt changed after the last step";
  for (const size_t place : {24, 32, 40}) {
    for (const double value : {nan, infinite, -1.0})
      EXPECT_TRUE(refusal(with(facts + place, value)).starts_with(altered)) << place << ' ' << value;
  }
  EXPECT_TRUE(refusal(with(facts + 32, 0.0)).starts_with(altered)) << "no time step";
  EXPECT_TRUE(refusal(with(facts + 32, 0.03)).starts_with(altered)) << "not that of the scene";
  std::string far = with(facts + 8, uint64_t{1} << 60);
  far.replace(facts + 48, 8, far, facts + 8, 8);
  EXPECT_TRUE(refusal(resealed(far)).starts_with(altered)) << "more steps than any run has";
  for (const size_t place : {size_t{224}, size_t{228}, 224 + 24 * n - 4}) {
    EXPECT_TRUE(refusal(with(facts + place, static_cast<float>(nan))).starts_with(altered)) << place;
    EXPECT_TRUE(refusal(with(facts + place, static_cast<float>(infinite))).starts_with(altered)) << place;
  }
}

TEST_F(DamagedCheckpoint, AHeaderThatIsNoneIsRefused) {
  for (const char* word : {"\"text\"", "\"overrides\"", "\"precision\"", "\"float\"", "\"file\"", "{"}) {
    std::string changed = bytes;
    changed[changed.find(word, 25) + std::string(word).size() / 2] = '#';
    EXPECT_TRUE(refusal(resealed(changed)).starts_with(altered)) << word;
  }
}

TEST_F(DamagedCheckpoint, ASceneInsideThatCannotBeRunIsNamed) {
  const auto with_scene = [&](const std::string& found, const std::string& instead) {
    Scene strange = saved.scene;
    strange.record.overrides.clear();
    strange.record.text.replace(strange.record.text.find(found), found.size(), instead);
    CheckpointWriter(folder / "strange.ckp", strange, Precision::single_, "a test")
        .write(saved.state, saved.counts);
    return refusal_of(folder / "strange.ckp");
  };
  const std::string unknown = with_scene("spacing", "spacung");
  EXPECT_TRUE(unknown.starts_with("found a scene in it that can't be run here: ")) << unknown;
  EXPECT_NE(unknown.find("particles.spacung: found an unknown key"), std::string::npos) << unknown;
  const std::string huge = with_scene("spacing = 8.0", "spacing = 0.01");
  EXPECT_NE(huge.find("particles.spacing: found 0.01"), std::string::npos) << huge;
}

}  // namespace
}  // namespace sluice::test
