// Valid runs that may not be worth much say so, and files do not overwrite each other.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

using Words = std::vector<std::string>;

std::string warnings_of(Words more) {
  Words words = {"run", "breaking_dam", "--backend", "cpu", "--threads", "1"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words).err;
}

void expect_warning(const Words& words, const std::string& part) {
  const std::string text = warnings_of(words);
  EXPECT_NE(text.find("sluice: warning: "), std::string::npos) << text;
  EXPECT_NE(text.find(part), std::string::npos) << text;
  Words quiet = words;
  quiet.push_back("--quiet");
  EXPECT_EQ(warnings_of(quiet).find("warning"), std::string::npos);
}

TEST(CliWarnings, ASoundRunHasNone) { EXPECT_EQ(warnings_of({"--steps", "50"}), ""); }

TEST(CliWarnings, ViscosityBeyondItsLimit) {
  expect_warning(
      {"--steps", "1", "--set", "viscosity.coefficient=1500"},
      "viscosity.coefficient dt / spacing^2 is 0.94, above the limit of an explicit viscosity, about 0.5");
  EXPECT_EQ(warnings_of({"--steps", "1", "--set", "viscosity.coefficient=799"}), "");
  expect_warning({"--steps", "1", "--set", "viscosity={model=\"xsph\",coefficient=2.5}"},
                 "viscosity.coefficient is 2.5, and above about 2 XSPH");
  EXPECT_EQ(warnings_of({"--steps", "1", "--set", "viscosity={model=\"xsph\",coefficient=1}"}), "");
}

TEST(CliWarnings, TimeStepsThatSoundOutruns) {
  const auto one_step = [](const std::string& method, const std::string& dt) {
    return Words{"--steps", "1", "--set", "pressure.method=" + method, "--set", dt};
  };
  expect_warning(
      one_step("wcsph", "pressure.wcsph.dt=0.014"),
      "sound travels 1.5 spacings in a step, and above about 1.35 a state equation tends to blow up; "
      "use a smaller pressure.wcsph.dt or pressure.wcsph.kappa");
  expect_warning(one_step("ssph", "time.dt=0.018"), "use a smaller time.dt or pressure.ssph.stiffness");
  EXPECT_EQ(warnings_of(one_step("wcsph", "pressure.wcsph.dt=0.012")), "");
  EXPECT_EQ(warnings_of(one_step("ssph", "time.dt=0.014")), "");
}

TEST(CliWarnings, TimeStepsTooLongForTheDepth) {
  expect_warning({"--steps", "1", "--set", "viscosity.coefficient=0", "--set", "time.dt=0.2"},
                 "dt sqrt(g depth) / spacing is 1.2, and above about 0.8 the pressure of deep fluid pushes "
                 "particles through the floor; use a smaller time.dt");
  EXPECT_EQ(warnings_of({"--steps", "1", "--set", "viscosity.coefficient=0", "--set", "time.dt=0.13"}), "");
}

// Steps that adapt keep below every bound by themselves, but not below dt_min.
TEST(CliWarnings, OfAdaptiveStepsTheSmallestCounts) {
  const auto adaptive = [](const std::string& least) {
    return Words{"--steps", "1",
                 "--set",   "viscosity.coefficient=0",
                 "--set",   "time.cfl=0.4",
                 "--set",   "time.dt_max=1",
                 "--set",   "time.dt_min=" + least};
  };
  expect_warning(adaptive("0.2"), "dt sqrt(g depth) / spacing is 1.2");
  expect_warning(adaptive("0.2"), "use a smaller time.dt_min");
  EXPECT_EQ(warnings_of(adaptive("0.01")), "");
}

TEST(CliWarnings, OfAdaptiveStepsTheKeyThatCounts) {
  const Words quick{"--steps", "40",
                    "--set",   "time.cfl=3",
                    "--set",   "time.dt_min=1e-6",
                    "--set",   "time.dt_max=1",
                    "--set",   "viscosity.coefficient=0",
                    "--set",   "fluid.gravity=[0,0]",
                    "--set",   "boundary.container=[]",
                    "--set",   "fluid.rect.0.velocity=[0,20]"};
  expect_warning(quick, "spacings in one step; use a smaller time.cfl");
}

TEST(CliWarnings, StepsBeyondTheRangeOfFloatAreRefused) {
  const ProgramResult result = run_program(
      {"run", "breaking_dam", "--backend", "cpu", "--set", "time.dt=1e-50", "--set", "time.duration=1e-47"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("found steps of 1e-50, beyond the range of this precision"), std::string::npos)
      << result.err;
}

TEST(CliWarnings, SoundSlowerThanAFall) {
  const auto stiffness = [](const std::string& k) {
    return Words{"--steps", "1", "--set", "pressure.method=ssph", "--set", "pressure.ssph.stiffness=" + k};
  };
  expect_warning(stiffness("2e3"),
                 "the speed of sound is 44.7, and fluid may hit a wall at 70.9; below that it goes through "
                 "walls; use a larger pressure.ssph.stiffness");
  EXPECT_EQ(warnings_of(stiffness("1e4")), "");
}

TEST(CliWarnings, MirrorWallsOfTooFewLayers) {
  expect_warning({"--steps", "0", "--set", "boundary.container.0.layers=2"},
                 "boundary.container.0.layers is 2, and mirror samples fill the kernel with 3");
  EXPECT_EQ(warnings_of(
                {"--steps", "0", "--set", "boundary.container.0.layers=2", "--set", "boundary.model=akinci"}),
            "");
}

TEST(CliWarnings, AnInvalidRunNamesWhatMayHelp) {
  for (const auto& [change, remedy] :
       {std::pair("time.dt=0.0045", "a smaller time.dt often helps"),
        std::pair("pressure.wcsph.dt=0.0045", "a smaller pressure.wcsph.dt often helps"),
        std::pair("viscosity.coefficient=3", "a viscosity.coefficient below 2 helps"),
        std::pair("pressure.wcsph.kappa=1", "a larger pressure.wcsph.kappa often helps"),
        std::pair("boundary.container.0.layers=3", "look whether fluid starts inside a wall")}) {
    const ProgramResult result = run_program({"run", "wcsph_box", "--quiet", "--set", change});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find(remedy), std::string::npos) << result.err;
  }
}

TEST(CliWarnings, StepsThatDidNotConverge) {
  expect_warning({"--steps", "100", "--set", "pressure.iisph.max_iterations=2"},
                 "of 100 steps did not converge; use pressure.iisph.solver \"barzilai-borwein\", "
                 "pressure.iisph.wall \"symmetric\", a smaller time.dt or");
  expect_warning(
      {"--steps", "100", "--set", "pressure.iisph.max_iterations=2", "--set", "pressure.iisph.wall=symmetric",
       "--set", "pressure.iisph.solver=barzilai-borwein", "--set", "pressure.iisph.tolerance=1e-6"},
      "of 100 steps did not converge; use a smaller time.dt or");
}

TEST(CliWarnings, MovesOfMoreThanASpacing) {
  expect_warning({"--steps", "10", "--set", "fluid.rect.0.velocity=[300,0]"}, "spacings in one step");
}

TEST(CliWarnings, AFluidThatGivesWay) {
  expect_warning({"--steps", "300", "--set", "pressure.method=ssph", "--set", "pressure.ssph.stiffness=2e3"},
                 "compressed by");
}

TEST(CliWarnings, LostParticles) {
  expect_warning({"--steps", "5", "--set", "domain.min=[30,0]"}, "particles left the domain");
}

TEST(CliWarnings, PicturesOfALongerRun) {
  const TemporaryFolder folder;
  const Words frames = {"--frames", folder.path.string(), "--size", "50x75", "--steps"};
  Words longer = frames, shorter = frames;
  longer.push_back("4");
  shorter.push_back("2");
  EXPECT_EQ(warnings_of(longer), "");
  EXPECT_NE(
      warnings_of(shorter).find("2 more pictures in " + folder.path.string() + " are from an earlier run"),
      std::string::npos);
}

TEST(CliClashes, OneFileForTwoOutputsIsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder / "both.csv";
  const ProgramResult result = run_program({"run", "breaking_dam", "--state", file, "--series", file});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err.substr(result.err.find("sluice: --")),
            "sluice: --series: found " + file + ", which is --state too, expected a place of its own\n");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(CliClashes, TheSceneIsNotOverwritten) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.toml";
  std::filesystem::copy_file(std::filesystem::path(SLUICE_SOURCE_DIR) / "scenes/breaking_dam.toml", scene);
  const std::string before = read_file(scene);
  for (const char* option : {"--state", "--series", "--summary"}) {
    const ProgramResult result = run_program({"run", scene, option, scene, "--steps", "1"});
    EXPECT_EQ(result.code, 2) << option;
    EXPECT_NE(result.err.find("which is the scene too"), std::string::npos) << result.err;
  }
  EXPECT_EQ(read_file(scene), before);
}

TEST(CliClashes, DevicesMayBeSharedAsUsual) {
  EXPECT_EQ(
      run_program({"run", "breaking_dam", "--steps", "1", "--state", "/dev/null", "--series", "/dev/null"})
          .code,
      0);
}

// The pictures fail in the middle of the run; the rows before that are not lost with them.
TEST(CliFailedFrames, TheSeriesIsKept) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "frames/frame_000003.png/in_the_way");
  const ProgramResult result =
      run_program({"run", "breaking_dam", "--backend", "cpu", "--threads", "1", "--steps", "50", "--size",
                   "50x75", "--frames", folder / "frames", "--series", folder / "series.csv"});
  EXPECT_EQ(result.code, 3) << result.err;
  EXPECT_NE(result.err.find("frame_000003.png"), std::string::npos) << result.err;
  const std::string series = read_file(folder / "series.csv");
  EXPECT_NE(series.find("\n3,"), std::string::npos) << series;
  EXPECT_EQ(series.back(), '\n');
}

TEST(CliInfo, TakesOverrides) {
  const ProgramResult result = run_program({"info", "breaking_dam", "--set", "particles.spacing=4"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("particles: 2820 fluid"), std::string::npos) << result.out;
  EXPECT_EQ(run_program({"info", "--set", "particles.spacing=4"}).code, 2);
}

}  // namespace
}  // namespace sluice::test
