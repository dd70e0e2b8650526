// `sluice run --record` and `sluice export`: what is made of a recording is what the run itself makes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/support/running_program.hpp"

namespace sluice::test {
namespace {

using Words = std::vector<std::string>;
namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

void expect_same_files(const fs::path& a, const fs::path& b, size_t count) {
  ASSERT_EQ(files_in(a), files_in(b));
  EXPECT_EQ(files_in(a).size(), count);
  for (const fs::path& name : files_in(a)) EXPECT_EQ(read_file(a / name), read_file(b / name)) << name;
}

struct Run {
  std::string name;
  Words words;
  size_t frames;
  friend void PrintTo(const Run& run, std::ostream* out) { *out << run.name; }
};
class ExportOf : public testing::TestWithParam<Run> {};

TEST_P(ExportOf, MakesTheSamePicturesAndFilesAsTheRun) {
  const TemporaryFolder folder;
  Words run = GetParam().words;
  run.insert(run.begin(), "run");
  run.insert(run.end(), {"--quiet", "--overlay", "all", "--record", folder / "a.rec", "--frames",
                         folder / "frames", "--vtk", folder / "vtk"});
  const auto first = run_program(run);
  ASSERT_EQ(first.code, 0) << first.err;
  const auto second = run_program({"export", folder / "a.rec", "--overlay", "all", "--frames",
                                   folder / "frames2", "--vtk", folder / "vtk2"});
  ASSERT_EQ(second.code, 0) << second.err;
  expect_same_files(folder / "frames", folder / "frames2", GetParam().frames);
  expect_same_files(folder / "vtk", folder / "vtk2", GetParam().frames + 2);
}

const Run runs[] = {
    {"CpuFloat", {"breaking_dam", "--backend", "cpu", "--time", "0.8"}, 21},
    {"CpuDouble", {"wcsph_box", "--precision", "double", "--steps", "60"}, 4},
    {"Gpu", {"breaking_dam", "--backend", "gpu", "--time", "0.8", "--colour", "pressure"}, 21},
    {"MoreFramesThanSteps", {"inclined_plane", "--backend", "cpu", "--steps", "3", "--fps", "100"}, 13},
};
std::string run_name(const testing::TestParamInfo<Run>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Runs, ExportOf, testing::ValuesIn(runs), run_name);

TEST(Export, ChangesSizeColourAndOverlay) {
  const TemporaryFolder folder;
  const Words changes{"--size", "120x90", "--colour", "density", "--overlay", "none"};
  Words run{"run", "breaking_dam", "--steps", "5", "--quiet", "--frames", folder / "frames"};
  run.insert(run.end(), changes.begin(), changes.end());
  ASSERT_EQ(run_program(run).code, 0);
  ASSERT_EQ(
      run_program({"run", "breaking_dam", "--steps", "5", "--quiet", "--record", folder / "a.rec"}).code, 0);
  Words exported{"export", folder / "a.rec", "--frames", folder / "frames2"};
  exported.insert(exported.end(), changes.begin(), changes.end());
  const auto result = run_program(exported);
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "6 pictures in " + (folder / "frames2").string() + "\n");
  expect_same_files(folder / "frames", folder / "frames2", 6);
}

TEST(Export, OfAnInvalidRunShowsItsLastFiniteState) {
  const TemporaryFolder folder;
  const auto run =
      run_program({"run", "wcsph_box", "--set", "time.dt=0.0045", "--fps", "1000", "--size", "120x120",
                   "--quiet", "--record", folder / "a.rec", "--frames", folder / "frames"});
  ASSERT_EQ(run.code, 1) << run.err;
  const auto result = run_program(
      {"export", folder / "a.rec", "--frames", folder / "frames2", "--size", "120x120", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const size_t count = files_in(folder / "frames").size();
  EXPECT_GT(count, 100u);
  expect_same_files(folder / "frames", folder / "frames2", count);
}

TEST(Export, RefusesByName) {
  const TemporaryFolder folder;
  const std::string name = folder / "a.rec";
  ASSERT_EQ(run_program({"run", "inclined_plane", "--steps", "2", "--quiet", "--record", name}).code, 0);
  const auto nothing = run_program({"export", name});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_EQ(nothing.err,
            "sluice: export: found nothing to write, expected --frames DIR, --video FILE.mp4 or --vtk DIR\n");
  fs::resize_file(name, fs::file_size(name) - 1);
  const auto cut = run_program({"export", name, "--frames", folder / "frames"});
  EXPECT_EQ(cut.code, 2);
  EXPECT_TRUE(cut.err.starts_with("sluice: " + name + ": found a recording that was cut off or altered"))
      << cut.err;
  EXPECT_FALSE(fs::exists(folder / "frames"));
}

TEST(Export, InterruptedItKeepsWhatItHas) {
  const TemporaryFolder folder;
  const std::string name = folder / "a.rec";
  ASSERT_EQ(run_program({"run", "breaking_dam", "--time", "20", "--quiet", "--record", name}).code, 0);
  RunningProgram program(
      {"export", name, "--size", "2000x3000", "--frames", folder / "frames", "--vtk", folder / "vtk"});
  while (program.running() && !fs::exists(folder / "frames/frame_000003.png"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("of 501; what was asked for is written up to there"), std::string::npos)
      << result.err;
  const size_t count = files_in(folder / "frames").size();
  EXPECT_GT(count, 3u);
  EXPECT_LT(count, 501u);
  EXPECT_EQ(files_in(folder / "vtk").size(), count + 2);
}

TEST(Export, ARecordingMayNotOverwriteAnotherOutput) {
  const TemporaryFolder folder;
  const std::string name = folder / "a";
  const auto result =
      run_program({"run", "inclined_plane", "--steps", "1", "--record", name, "--series", name});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("which is --series too"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(name));
}

/// Rows that fill a buffer fail in mid-run, a few rows only when the file is finished.
TEST(Export, AFailedRunKeepsTheFramesItHas) {
  for (const char* steps : {"4000", "20"}) {
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"run", "breaking_dam", "--backend", "cpu", "--steps", steps,
                                              "--quiet", "--series", "/dev/full", "--summary", "/dev/full",
                                              "--record", folder / "a.rec", "--vtk", folder / "vtk"});
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_TRUE(fs::exists(folder / "vtk/fluid.pvd"));
    const ProgramResult exported =
        run_program({"export", folder / "a.rec", "--vtk", folder / "vtk2", "--quiet"});
    EXPECT_EQ(exported.code, 0) << exported.err;
    EXPECT_GT(files_in(folder / "vtk2").size(), 5u);
  }
}

TEST(Export, AnOutputThatFailsAtTheEndTakesNoOtherWithIt) {
  const TemporaryFolder folder;
  const ProgramResult run = run_program({"run", "breaking_dam", "--steps", "3", "--quiet", "--record",
                                         "/dev/full", "--video", folder / "a.mp4", "--vtk", folder / "vtk"});
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.err.find("/dev/full"), std::string::npos) << run.err;
  EXPECT_TRUE(fs::exists(folder / "a.mp4"));
  EXPECT_TRUE(fs::exists(folder / "vtk/fluid.pvd"));
}

TEST(Export, DoesNotOverwriteTheRecording) {
  const TemporaryFolder folder;
  const std::string name = folder / "a.mp4";
  ASSERT_EQ(run_program({"run", "inclined_plane", "--steps", "2", "--quiet", "--record", name}).code, 0);
  const std::string bytes = read_file(name);
  const ProgramResult result = run_program({"export", name, "--video", name});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("which is the recording too"), std::string::npos) << result.err;
  EXPECT_EQ(read_file(name) == bytes, true);
}

TEST(Export, ARecordingWhereASceneIsWantedIsNamedSo) {
  const TemporaryFolder folder;
  const std::string name = folder / "a.rec";
  ASSERT_EQ(run_program({"run", "inclined_plane", "--steps", "2", "--quiet", "--record", name}).code, 0);
  for (const char* command : {"run", "info", "agree"}) {
    const ProgramResult result = run_program({command, name});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, fmt::format("sluice: {}: found a recording, expected a scene; use `sluice play` or "
                                      "`sluice export` for it\n",
                                      name));
  }
}

TEST(Export, TwoOutputsInOnePlaceAreRefused) {
  const TemporaryFolder folder;
  const std::string one = folder / "one";
  for (const Words& pair : {Words{"--frames", one, "--vtk", one + "/"}, {"--frames", one, "--record", one}}) {
    Words words{"run", "inclined_plane", "--steps", "1"};
    words.insert(words.end(), pair.begin(), pair.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("too, expected a place of its own"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(one));
  }
}

TEST(Export, ShowsItsProgressOnATerminal) {
  const TemporaryFolder folder;
  const std::string name = folder / "a.rec";
  ASSERT_EQ(run_program({"run", "breaking_dam", "--time", "2", "--quiet", "--record", name}).code, 0);
  RunningProgram program({"export", name, "--frames", folder / "frames"},
                         {.environment = {}, .terminal = true});
  const std::string shown = program.wait().err;
  EXPECT_NE(shown.find(" frames/s  dt 0.04 "), std::string::npos) << shown;
}

TEST(Export, ManyFramesAreRefusedOnlyWhereFramesAreMade) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"run", "inclined_plane", "--steps", "3", "--quiet", "--fps", "1e12"}).code, 0);
  for (const char* steps : {"0", "3"}) {
    const ProgramResult result = run_program(
        {"run", "inclined_plane", "--steps", steps, "--quiet", "--fps", "1e16", "--vtk", folder / "vtk"});
    EXPECT_EQ(result.code, 2) << steps;
    EXPECT_NE(result.err.find("frames, expected at most 1e+06"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace sluice::test
