// What may be resumed with what: the scene, its overrides, the precision, and where things are written.
#include <gtest/gtest.h>

#include <fstream>

#include "core/output/checkpoint.hpp"
#include "sluice/load.hpp"
#include "tests/support/checkpointed.hpp"

namespace sluice::test {
namespace {

class CliResume : public CheckpointFolder {
 protected:
  CliResume() { run({"breaking_dam", "--steps", "2", "--checkpoint", "a.ckp"}); }

  void expect_refused(const Words& words, const Words& parts) {
    const std::string message = run(words, 2);
    for (const std::string& part : parts) EXPECT_TRUE(has(message, part)) << part << " in: " << message;
  }
};

TEST_F(CliResume, ASceneThatIsTheSameIsAccepted) {
  run({"--resume", "a.ckp", "--steps", "5", "--state", "none.csv"});
  run({"breaking_dam", "--resume", "a.ckp", "--steps", "5", "--state", "named.csv"});
  std::string text = load_scene("breaking_dam").record.text;
  std::ofstream(folder / "mine.toml") << "# the same scene, with a remark\n" << text;
  run({"mine.toml", "--resume", "a.ckp", "--steps", "5", "--state", "mine.csv"});
  EXPECT_TRUE(bytes("none.csv") == bytes("named.csv"));
  EXPECT_TRUE(bytes("none.csv") == bytes("mine.csv"));
}

TEST_F(CliResume, OutputTitleAndDurationMayChange) {
  run({"--resume", "a.ckp", "--set", "time.duration=0.2", "--set", "scene.title=On", "--set",
       "scene.source=here", "--set", "output.fps=5", "--size", "60x40", "--colour", "pressure", "--summary",
       "s.json"});
  const auto summary = read_json(folder / "s.json");
  EXPECT_EQ(summary["steps"], 5);
  EXPECT_EQ(summary["title"], "On");
  EXPECT_EQ(summary["settings"]["output"]["colour"], "pressure");
}

TEST_F(CliResume, AnythingElseThatDiffersIsNamedWithBothValues) {
  expect_refused({"--resume", "a.ckp", "--set", "viscosity.coefficient=100"},
                 {"a.ckp: ", "viscosity.coefficient 200.0", "expected one with 100.0"});
  expect_refused({"breaking_dam", "--resume", "a.ckp", "--set", "particles.spacing=4"},
                 {"a.ckp: ", "particles.spacing 8.0", "4.0"});
  expect_refused({"--resume", "a.ckp", "--set", "fluid.rect.0.velocity=[1,0]"},
                 {"fluid.rect.0.velocity [0.0,0.0]", "[1.0,0.0]"});
  expect_refused({"--resume", "a.ckp", "--set", "time.dt=0.02"}, {"pressure.ssph.dt 0.01", "none"});
  expect_refused({"--resume", "a.ckp", "--set", "pressure.iisph.dt=0.02"},
                 {"pressure.iisph.dt none", "expected one with 0.02"});
  expect_refused({"--resume", "a.ckp", "--set", "fluid.disc.0={centre=[300,300],radius=20}"},
                 {"fluid.disc none", "300.0"});
  expect_refused({"leaking_dam", "--resume", "a.ckp"}, {"a.ckp: ", "particles.spacing 8.0", "4.0"});
  expect_refused({"--resume", "a.ckp", "--set", "fluid.gravty=[0,0]"}, {"fluid.gravty"});
  expect_refused({"nowhere.toml", "--resume", "a.ckp"}, {"nowhere.toml"});
}

TEST_F(CliResume, TheOverridesOfTheCheckpointStay) {
  run({"breaking_dam", "--steps", "2", "--set", "viscosity.coefficient=50", "--checkpoint", "b.ckp"});
  run({"--resume", "b.ckp", "--steps", "4", "--state", "part.csv", "--checkpoint", "b.ckp"});
  run({"breaking_dam", "--resume", "b.ckp", "--steps", "6", "--state", "part.csv"});
  run({"breaking_dam", "--steps", "6", "--set", "viscosity.coefficient=50", "--state", "whole.csv"});
  EXPECT_TRUE(bytes("part.csv") == bytes("whole.csv"));
  expect_refused({"breaking_dam", "--resume", "b.ckp", "--set", "viscosity.coefficient=200"},
                 {"viscosity.coefficient 50.0", "200.0"});
  run({"breaking_dam", "--steps", "2", "--set", "boundary.container.0.layers=2", "--checkpoint", "c.ckp"});
  expect_refused({"wcsph_box", "--resume", "c.ckp", "--set", "boundary.container.7.layers=2"},
                 {"boundary.container.7", "with the overrides in c.ckp applied first"});
}

TEST_F(CliResume, ThePrecisionMustBeGiven) {
  run({"breaking_dam", "--steps", "2", "--precision", "double", "--checkpoint", "d.ckp"});
  expect_refused({"--resume", "d.ckp"}, {"d.ckp: found a checkpoint in double", "give --precision double"});
  expect_refused({"--resume", "a.ckp", "--precision", "double"},
                 {"a.ckp: found a checkpoint in float", "give --precision float"});
  expect_refused({"--resume", "d.ckp", "--precision", "double", "--backend", "gpu"}, {"--backend gpu"});
}

TEST_F(CliResume, AsManyParticlesAsTheSceneHas) {
  Checkpoint found = read_checkpoint(folder / "a.ckp");
  found.state.x.pop_back();
  found.state.v.pop_back();
  found.state.density.pop_back();
  found.state.pressure.pop_back();
  CheckpointWriter(folder / "a.ckp", found.scene, found.precision, "a test").write(found.state, found.counts);
  expect_refused({"--resume", "a.ckp"}, {"a.ckp: found 659 particles, expected the 660 of its scene"});
}

TEST_F(CliResume, OptionsThatDoNotGoTogether) {
  expect_refused({"breaking_dam", "--checkpoint-every", "5"}, {"--checkpoint-every", "--checkpoint"});
  for (const char* value : {"0", "-1", "x", "nan", "inf", ""})
    expect_refused({"breaking_dam", "--checkpoint", "b.ckp", "--checkpoint-every", value},
                   {"--checkpoint-every: found \""});
  for (const char* option : {"--checkpoint", "--resume"})
    expect_refused({"breaking_dam", option, ""}, {option, "empty name"});
  expect_refused({}, {"SCENE", "--resume"});
  expect_refused({"", "--resume", "a.ckp"}, {"found no such file"});
  expect_refused({"a.ckp"}, {"a.ckp: found a checkpoint", "--resume a.ckp"});
  for (const char* command : {"info", "agree", "play"}) {
    const ProgramResult result = run_program({command, "a.ckp"}, folder.path);
    EXPECT_EQ(result.code, 2) << command;
    EXPECT_TRUE(has(result.err, "a.ckp: found a checkpoint, expected a scene")) << result.err;
  }
  EXPECT_EQ(names_in(folder.path), Words{"a.ckp"});
}

TEST_F(CliResume, NothingIsWrittenOverWhatIsRead) {
  const std::string before = bytes("a.ckp");
  for (const char* option : {"--state", "--series", "--summary", "--record"})
    expect_refused({"--resume", "a.ckp", option, "./a.ckp"}, {option, "a.ckp", "--resume"});
  for (const char* option : {"--state", "--series", "--summary", "--record"})
    expect_refused({"breaking_dam", option, "b.ckp", "--checkpoint", "b.ckp"},
                   {option, "b.ckp", "--checkpoint"});
  std::ofstream(folder / "mine.toml") << load_scene("breaking_dam").record.text;
  expect_refused({"mine.toml", "--checkpoint", "mine.toml"}, {"mine.toml", "the scene"});
  EXPECT_EQ(bytes("a.ckp"), before);
  EXPECT_EQ(names_in(folder.path), (Words{"a.ckp", "mine.toml"}));
}

// Two folders that are there already are not one.
TEST_F(CliResume, FoldersBesideEachOtherDoNotClash) {
  for (int time = 0; time < 2; ++time)
    run({"--resume", "a.ckp", "--steps", "3", "--frames", "frames", "--vtk", "vtk", "--size", "40x60"});
  expect_refused({"--resume", "a.ckp", "--frames", "vtk", "--vtk", "vtk/"}, {"--vtk", "--frames"});
  expect_refused({"--resume", "a.ckp", "--frames", "new/", "--vtk", folder / "new"}, {"--vtk", "--frames"});
}

TEST_F(CliResume, FilesThatAreNoCheckpointAreRefusedByName) {
  run({"breaking_dam", "--steps", "1", "--record", "r.rec", "--frames", "f", "--size", "40x60"});
  std::ofstream(folder / "empty");
  std::ofstream(folder / "cut.ckp", std::ios::binary) << bytes("a.ckp").substr(0, 9000);
  for (const char* name :
       {"r.rec", "f/frame_000000.png", "empty", "f", "missing.ckp", "cut.ckp", "/dev/null"})
    expect_refused({"breaking_dam", "--resume", name, "--state", "s.csv"}, {std::string(name) + ": found "});
  EXPECT_FALSE(std::filesystem::exists(folder / "s.csv"));
  expect_refused({"r.rec", "--resume", "a.ckp"}, {"r.rec: found a recording"});
}

}  // namespace
}  // namespace sluice::test
