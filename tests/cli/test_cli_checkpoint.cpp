// A run that goes on from a checkpoint is the run that never stopped: state, series, summary, frames, files
// for ParaView and recordings.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/output/checkpoint.hpp"
#include "gpu/context.hpp"
#include "media/recording.hpp"
#include "tests/support/checkpointed.hpp"

namespace sluice::test {
namespace {

/// Everything of a summary that does not depend on how fast the machine is.
nlohmann::ordered_json facts_of(nlohmann::ordered_json summary) {
  summary.erase("seconds");
  summary.erase("particle_sweeps_per_second");
  return summary;
}

class CliCheckpoint : public CheckpointFolder {
 protected:
  /// State, series and summary under this name, with the summary's facts compared and the rest byte by byte.
  Words outputs(const std::string& name) const {
    return {"--state", name + ".csv", "--series", name + ".rows", "--summary", name + ".json"};
  }
  /// `part` is `whole` from the step after `from` on.
  void expect_tail(const std::string& whole, const std::string& part, size_t from) {
    EXPECT_TRUE(bytes(whole + ".csv") == bytes(part + ".csv"));
    EXPECT_EQ(facts_of(read_json(folder / (whole + ".json"))),
              facts_of(read_json(folder / (part + ".json"))));
    Table rows = read_table(folder / (whole + ".rows")), tail = read_table(folder / (part + ".rows"));
    rows.rows.erase(rows.rows.begin(), rows.rows.begin() + static_cast<std::ptrdiff_t>(from));
    EXPECT_EQ(rows.header, tail.header);
    EXPECT_TRUE(rows.rows == tail.rows);
  }
};

TEST_F(CliCheckpoint, AResumedRunHasTheBytesOfTheWholeOne) {
  const Words start{"--set", "fluid.jitter=0.1", "--set", "fluid.relax=2"};
  for (const Words& machine :
       {Words{"--backend", "cpu", "--precision", "float"}, Words{"--backend", "cpu", "--precision", "double"},
        Words{"--backend", "gpu"}}) {
    SCOPED_TRACE(machine.back());
    run(Words{"breaking_dam", "--steps", "16"} + start + machine + outputs("whole"));
    run(Words{"breaking_dam", "--steps", "7", "--checkpoint", "a.ckp"} + start + machine);
    run(Words{"--resume", "a.ckp", "--steps", "16"} + machine + outputs("part"));
    expect_tail("whole", "part", 7);
    run(Words{"--resume", "a.ckp", "--time", "0.64"} + machine + outputs("part"));  // 16 steps too
    expect_tail("whole", "part", 7);
  }
}

TEST_F(CliCheckpoint, EveryMethodGoesOn) {
  for (const Words& scene :
       {Words{"breaking_dam", "--set", "pressure.method=ssph"}, Words{"wcsph_box"}, Words{"iisph_box"},
        Words{"breaking_dam", "--set", "pressure.iisph.solver=barzilai-borwein", "--set",
              "pressure.iisph.warm_start=1"}}) {
    SCOPED_TRACE(scene.back());
    const Words machine{"--backend", "cpu"};
    run(scene + machine + outputs("whole") + Words{"--steps", "12"});
    run(scene + machine + Words{"--steps", "5", "--checkpoint", "a.ckp"});
    run(Words{"--resume", "a.ckp", "--steps", "12"} + machine + outputs("part"));
    expect_tail("whole", "part", 5);
  }
}

// The last steps of a run that ends at a time are cut short. One that goes on has none of them.
TEST_F(CliCheckpoint, StepsThatAdaptGoOnAsIfTheFirstEndHadNotBeen) {
  const Words adaptive{"breaking_dam", "--set",           "time.cfl=0.05", "--set", "time.dt_min=0.001",
                       "--set",        "time.dt_max=0.1", "--backend",     "cpu"};
  run(adaptive + Words{"--time", "1.3", "--checkpoint", "whole.ckp"} + outputs("whole"));
  run(adaptive + Words{"--time", "0.7", "--checkpoint", "a.ckp"} + outputs("first"));
  EXPECT_EQ(read_json(folder / "first.json")["time"], 0.7);
  const size_t from = read_checkpoint(folder / "a.ckp").state.clock.steps;
  EXPECT_LT(from, read_json(folder / "first.json")["steps"].get<size_t>())
      << "before the steps that were cut";
  run({"--resume", "a.ckp", "--time", "1.3", "--checkpoint", "b.ckp", "--backend", "cpu"});
  EXPECT_TRUE(bytes("whole.ckp") == bytes("b.ckp"));
  run(Words{"--resume", "a.ckp", "--time", "1.3", "--backend", "cpu"} + outputs("part"));
  expect_tail("whole", "part", from);
  run(Words{"--resume", "a.ckp", "--time", "0.7", "--backend", "cpu"} + outputs("part"));
  expect_tail("first", "part", from);
  const Table rows = read_table(folder / "whole.rows");
  EXPECT_NE(rows.text(2, "dt"), rows.text(rows.size() - 4, "dt")) << "they do adapt";
}

// A step that was cut short may still be too long, so that many follow where two were to be. A run with a
// later end has none of them, the repeated one included.
TEST_F(CliCheckpoint, AnEndThatTurnsOutFarOffLeavesTheCheckpointBeforeIt) {
  const Words adaptive{"breaking_dam",
                       "--set",
                       "time.cfl=1",
                       "--set",
                       "time.dt_min=1e-4",
                       "--set",
                       "time.dt_max=0.1",
                       "--set",
                       "pressure.iisph.solver=barzilai-borwein",
                       "--backend",
                       "cpu"};
  run(adaptive +
      Words{"--time", "5.34", "--checkpoint", "a.ckp", "--checkpoint-every", "0.01", "--summary", "a.json"});
  const size_t from = read_checkpoint(folder / "a.ckp").state.clock.steps;
  EXPECT_GT(read_json(folder / "a.json")["steps"].get<size_t>(), from + 2) << "many follow";
  run(adaptive + Words{"--time", "5.6", "--state", "whole.csv"});
  run({"--resume", "a.ckp", "--time", "5.6", "--state", "part.csv", "--backend", "cpu"});
  EXPECT_TRUE(bytes("whole.csv") == bytes("part.csv"));
}

TEST_F(CliCheckpoint, GoesOnASecondTimeUnderTheSameName) {
  run({"breaking_dam", "--steps", "15", "--checkpoint", "whole.ckp", "--state", "whole.csv"});
  run({"breaking_dam", "--steps", "4", "--checkpoint", "a.ckp"});
  run({"--resume", "a.ckp", "--steps", "9", "--checkpoint", "a.ckp"});
  run({"--resume", "a.ckp", "--steps", "15", "--checkpoint", "a.ckp", "--state", "a.csv"});
  EXPECT_TRUE(bytes("whole.csv") == bytes("a.csv"));
  EXPECT_TRUE(bytes("whole.ckp") == bytes("a.ckp")) << "the same run, in as many parts as you like";
}

TEST_F(CliCheckpoint, GoesOnOnTheOtherBackend) {
  if (!gpu::Context().software()) GTEST_SKIP() << "a graphics card, whose bits may differ";
  run({"breaking_dam", "--steps", "12", "--backend", "cpu", "--state", "whole.csv"});
  for (const auto& [first, second] : {std::pair("cpu", "gpu"), std::pair("gpu", "cpu")}) {
    run({"breaking_dam", "--steps", "5", "--backend", first, "--checkpoint", "a.ckp"});
    run({"--resume", "a.ckp", "--steps", "12", "--backend", second, "--state", "part.csv"});
    EXPECT_TRUE(bytes("whole.csv") == bytes("part.csv")) << second;
  }
}

TEST_F(CliCheckpoint, FramesGoOnWithTheirNumbersAndPixels) {
  const Words look{"--size", "120x180", "--fps", "20", "--overlay", "facts"};  // a frame in 1.25 steps
  for (const char* backend : {"cpu", "gpu"}) {
    const Words machine{"--backend", backend};
    run(Words{"breaking_dam", "--steps", "14", "--frames", "whole", "--vtk", "vtk"} + look + machine);
    run(Words{"breaking_dam", "--steps", "6", "--frames", "part", "--vtk", "part_vtk", "--checkpoint", "a"} +
        look + machine);
    const Words before = names_in(folder / "part");
    run(Words{"--resume", "a", "--steps", "14", "--frames", "tail", "--vtk", "tail_vtk"} + look + machine);
    const Words all = names_in(folder / "whole"), tail = names_in(folder / "tail");
    EXPECT_EQ(before + tail, all);
    EXPECT_EQ(before.size(), 5u);
    for (const std::string& name : tail) EXPECT_TRUE(bytes("whole/" + name) == bytes("tail/" + name)) << name;
    for (size_t k = before.size(); k < all.size(); ++k) {
      const std::string name = fmt::format("fluid_{:06}.vtp", k);
      EXPECT_TRUE(bytes("vtk/" + name) == bytes("tail_vtk/" + name)) << name;
    }
    EXPECT_FALSE(has(bytes("tail_vtk/fluid.pvd"), "fluid_000004.vtp")) << "it is not there";
    EXPECT_TRUE(has(bytes("tail_vtk/fluid.pvd"), "fluid_000005.vtp"));
    // In the folder of the first part the list has all.
    run(Words{"--resume", "a", "--steps", "14", "--vtk", "part_vtk"} + look + machine);
    EXPECT_EQ(names_in(folder / "part_vtk"), names_in(folder / "vtk"));
    EXPECT_EQ(bytes("part_vtk/fluid.pvd"), bytes("vtk/fluid.pvd"));
    for (const char* used : {"whole", "part", "tail", "vtk", "part_vtk", "tail_vtk"})
      std::filesystem::remove_all(folder / used);
  }
}

TEST_F(CliCheckpoint, ARecordingHoldsWhatIsDueAfterIt) {
  run({"breaking_dam", "--steps", "10", "--record", "whole.rec"});
  run({"breaking_dam", "--steps", "6", "--checkpoint", "a.ckp"});
  run({"--resume", "a.ckp", "--steps", "10", "--record", "tail.rec"});
  const media::Recording whole(folder / "whole.rec"), tail(folder / "tail.rec");
  ASSERT_EQ(whole.frames(), 11u);
  ASSERT_EQ(tail.frames(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(tail.moment(k).report.step, 7 + k);
    EXPECT_TRUE(tail.moment(k).state.x == whole.moment(7 + k).state.x);
    EXPECT_TRUE(tail.moment(k).state.pressure == whole.moment(7 + k).state.pressure);
  }
}

TEST_F(CliCheckpoint, PastTheEndItWritesWhatWasAskedForAndIsDone) {
  run(Words{"breaking_dam", "--steps", "8", "--checkpoint", "a.ckp"} + outputs("whole"));
  for (const Words& end : {Words{"--steps", "8"}, Words{"--steps", "3"}, Words{"--time", "0"}}) {
    run(Words{"--resume", "a.ckp", "--checkpoint", "b.ckp", "--frames", "f", "--record", "r.rec"} + end +
        outputs("part"));
    expect_tail("whole", "part", 8);
    EXPECT_EQ(read_table(folder / "part.rows").size(), 0u);
    EXPECT_EQ(read_json(folder / "part.json")["seconds"]["total"], 0.0);
    EXPECT_EQ(read_json(folder / "part.json")["particle_sweeps_per_second"], 0.0);
    EXPECT_TRUE(bytes("a.ckp") == bytes("b.ckp"));
    EXPECT_EQ(names_in(folder / "f"), Words{});
    EXPECT_FALSE(std::filesystem::exists(folder / "r.rec"));
  }
  const ProgramResult told =
      run_program({"run", "--resume", "a.ckp", "--steps", "8", "--record", "r.rec"}, folder.path);
  EXPECT_TRUE(has(told.out, "no frame was due, so there is no r.rec")) << told.out;
}

TEST_F(CliCheckpoint, OfTheStartIsTheStart) {
  const Words jitter{"--set", "fluid.jitter=0.1", "--set", "fluid.relax=1"};
  run(Words{"breaking_dam", "--steps", "0", "--checkpoint", "a.ckp"} + jitter + outputs("start"));
  run(Words{"--resume", "a.ckp", "--steps", "0"} + outputs("part"));
  expect_tail("start", "part", 0);
  run(Words{"breaking_dam", "--steps", "5"} + jitter + outputs("whole"));
  run(Words{"--resume", "a.ckp", "--steps", "5"} + outputs("part"));
  expect_tail("whole", "part", 0);
  run({"--resume", "a.ckp", "--steps", "1", "--frames", "f", "--size", "40x60"});
  EXPECT_EQ(names_in(folder / "f").front(), "frame_000001.png") << "the start was due before";
}

TEST_F(CliCheckpoint, IsWrittenEveryNowAndThen) {
  run({"breaking_dam", "--steps", "7", "--checkpoint", "at_7.ckp"});
  // Due at the steps 3, 5 and 8 of dt 0.04; the last may not end the run.
  const ProgramResult full = run_program({"run", "breaking_dam", "--steps", "7", "--quiet", "--checkpoint",
                                          "a.ckp", "--checkpoint-every", "0.1"},
                                         folder.path);
  EXPECT_EQ(full.code, 0) << full.err;
  EXPECT_TRUE(bytes("a.ckp") == bytes("at_7.ckp")) << "the end is one in any case";
}

TEST_F(CliCheckpoint, SweepsPerSecondAreThoseOfTheStepsMadeNow) {
  run({"breaking_dam", "--steps", "6", "--checkpoint", "a.ckp"});
  run({"--resume", "a.ckp", "--steps", "9", "--checkpoint", "b.ckp", "--summary", "s.json", "--backend",
       "cpu"});
  const auto summary = read_json(folder / "s.json");
  double seconds = 0;
  for (const char* stage :
       {"pressure_acceleration", "pressure_operator", "residual", "stop_test", "pressure_update"})
    seconds += summary["seconds"]["stages"][stage].get<double>();
  const uint64_t before = read_checkpoint(folder / "a.ckp").counts.iterations,
                 after = read_checkpoint(folder / "b.ckp").counts.iterations;
  ASSERT_GT(before, 0u);
  const auto sweeps = 660 * static_cast<double>(after - before);
  EXPECT_NEAR(summary["particle_sweeps_per_second"].get<double>() * seconds, sweeps, 1e-6 * sweeps);
}

TEST_F(CliCheckpoint, TheTableSaysWhichStepsWereMadeNow) {
  run({"breaking_dam", "--steps", "6", "--checkpoint", "a.ckp"});
  const ProgramResult result = run_program({"run", "--resume", "a.ckp", "--steps", "10"}, folder.path);
  EXPECT_TRUE(has(result.out, "Breaking dam: 10 steps of IISPH, 0.4 simulated, the last 4 in "))
      << result.out;
}

}  // namespace
}  // namespace sluice::test
