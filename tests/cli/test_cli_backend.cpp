// --backend, --gl-device and --shader-dir: what runs where, what is said about it, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/output_file.hpp"
#include "cpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A short run with these words more, with these variables more.
ProgramResult run(const Words& more, const Words& environment = {}) {
  Words words{"run", "breaking_dam", "--steps", "2", "--threads", "1"};
  words.insert(words.end(), more.begin(), more.end());
  RunningProgram program(words, {environment});
  return program.wait();
}

/// The dam with about 24,000 particles, enough for a graphics card to be looked for.
const Words large{"--set", "particles.spacing=1.4", "--set", "viscosity.coefficient=2",
                  "--set", "time.dt=0.007"};

const Words no_drivers{"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"};

/// Which libraries of OpenGL the program loaded, by what its loader says.
ProgramResult traced_run(const Words& more) { return run(more, {"LD_DEBUG=files"}); }
bool loaded_opengl(const ProgramResult& traced) {
  EXPECT_TRUE(has(traced.err, "file=libfmt")) << "the loader says nothing";
  return has(traced.err, "file=libEGL") || has(traced.err, "file=libOpenGL") || has(traced.err, "file=libGL");
}

TEST(CliBackend, TheGpuRunsAndTheSummarySaysSo) {
  const TemporaryFolder folder;
  const ProgramResult result = run({"--backend", "gpu", "--summary", folder / "sum.json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "backend: gpu, " + gpu::Context().renderer() + " (as asked for)\n");
  const auto summary = read_json(folder / "sum.json");
  EXPECT_EQ(summary["backend"], "gpu");
  EXPECT_EQ(summary["device"], gpu::Context().renderer());
  EXPECT_EQ(summary["precision"], "float");
  EXPECT_EQ(summary["steps"], 2);
  for (const auto& [stage, seconds] : summary["seconds"]["stages"].items())
    EXPECT_GT(seconds.get<double>(), 0) << stage;
}

TEST(CliBackend, TheGpuOfThisNumberRuns) {
  const auto devices = gpu::list_devices();
  for (const gpu::DeviceInfo& device : devices) {
    const ProgramResult result = run({"--backend", "gpu", "--gl-device", std::to_string(device.index)});
    EXPECT_EQ(result.code, device.problem.empty() ? 0 : 3) << result.err;
  }
  const ProgramResult result = run({"--backend", "gpu", "--gl-device", "99"});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(has(result.err, "there is no OpenGL device 99; the devices are\n" + gpu::describe(devices)))
      << result.err;
}

TEST(CliBackend, OptionsThatHaveNoEffectAreNamed) {
  const std::string shaders = (std::filesystem::path(SLUICE_SOURCE_DIR) / "shaders").string();
  const ProgramResult unused = run({"--backend", "cpu", "--shader-dir", shaders, "--gl-device", "0"});
  EXPECT_EQ(unused.code, 0);
  EXPECT_TRUE(has(unused.err, "--shader-dir has no effect") && has(unused.err, "--gl-device has no effect"))
      << unused.err;
  const ProgramResult used = run({"--backend", "gpu", "--shader-dir", shaders, "--gl-device", "0"});
  EXPECT_EQ(used.code, 0);
  EXPECT_FALSE(has(used.err, "has no effect")) << used.err;
}

TEST(CliBackend, AnyInstructionsGiveTheSameState) {
  const TemporaryFolder folder;
  std::string expected;
  for (const cpu::Instructions each : cpu::available_instructions()) {
    const std::string name(name_of(each));
    const ProgramResult result = run({"--backend", "cpu", "--instructions", name, "--state", folder / name});
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string state = read_file(folder / name);
    EXPECT_FALSE(state.empty());
    if (expected.empty()) expected = state;
    EXPECT_EQ(state, expected) << name;
  }
  EXPECT_EQ(run_program({"agree", "breaking_dam", "--steps", "1", "--instructions", "plain"}).code, 0);
  EXPECT_EQ(run_program({"agree", "breaking_dam", "--stage", "density", "--instructions", "plain"}).code, 0);
}

TEST(CliBackend, InstructionsThatAreNotThereAreRefused) {
  const ProgramResult unknown = run({"--instructions", "sse5"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(
      has(unknown.err, "--instructions: found \"sse5\", expected one of plain, baseline, avx2, avx512"))
      << unknown.err;
  const std::vector<cpu::Instructions> available = cpu::available_instructions();
  EXPECT_TRUE(
      has(run_program({"info"}).out, "instructions (for --instructions): " + cpu::names_of(available)));
  for (const cpu::Instructions each : values_of<cpu::Instructions>()) {
    if (std::count(available.begin(), available.end(), each) > 0) continue;
    const ProgramResult missing = run({"--instructions", std::string(name_of(each))});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(has(missing.err, "expected one of " + cpu::names_of(available))) << missing.err;
  }
}

TEST(CliBackend, TheGpuDoesNotComputeInDouble) {
  const ProgramResult result = run({"--backend", "gpu", "--precision", "double"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(has(result.err, "--precision double: found it with --backend gpu, expected --backend cpu"))
      << result.err;
}

TEST(CliBackend, InstructionsAreTheCpus) {
  const ProgramResult result = run({"--backend", "gpu", "--instructions", "plain"});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(has(result.err, "--instructions plain: found it with --backend gpu, expected --backend cpu"))
      << result.err;
  EXPECT_TRUE(has(run({"--instructions", "plain"}).err, "backend: cpu, 1 threads (--instructions"));
}

TEST(CliBackend, AutomaticInDoubleIsTheCpuWithoutOpenGl) {
  const ProgramResult result = traced_run({"--precision", "double"});
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result.err, "backend: cpu, 1 threads (double runs there)\n"));
  EXPECT_FALSE(loaded_opengl(result));
}

TEST(CliBackend, AutomaticTakesGraphicsCardsOnlyAndSaysWhatItTook) {
  const TemporaryFolder folder;
  const auto run_large = [&](const Words& environment) {
    Words words{"--summary", folder / "sum.json"};
    words.insert(words.end(), large.begin(), large.end());
    const ProgramResult result = run(words, environment);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.err;
  };
  const gpu::Context context;
  if (context.software()) {
    EXPECT_TRUE(has(run_large({}), "backend: cpu, 1 threads (OpenGL is drawn by the processor: " +
                                       context.renderer() + ")\n"));
    EXPECT_EQ(read_json(folder / "sum.json")["backend"], "cpu");
  }
  EXPECT_TRUE(
      has(run_large({"SLUICE_GL=hardware"}), "backend: gpu, " + context.renderer() + " (a graphics card)\n"));
  EXPECT_EQ(read_json(folder / "sum.json")["backend"], "gpu");
}

TEST(CliBackend, AutomaticComputesSmallRunsOnTheCpu) {
  EXPECT_EQ(run({}, {"SLUICE_GL=hardware"}).err,
            "backend: cpu, 1 threads (below about 20000 particles it is the faster one)\n");
  EXPECT_FALSE(loaded_opengl(traced_run({}))) << "nor is OpenGL asked";
  EXPECT_TRUE(has(run({"--backend", "gpu"}).err, "(as asked for)")) << "but whoever wants the card has it";
}

TEST(CliBackend, WithoutOpenGlTheGpuIsRefusedWithWhatToInstall) {
  const ProgramResult result = run({"--backend", "gpu"}, no_drivers);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(has(result.err, "sluice: no OpenGL 4.3 was found")) << result.err;
  EXPECT_TRUE(has(result.err, "libgl1-mesa-dri")) << result.err;
}

TEST(CliBackend, WithoutOpenGlAutomaticIsTheCpuAndSaysWhy) {
  const TemporaryFolder folder;
  Words words{"--summary", folder / "sum.json"};
  words.insert(words.end(), large.begin(), large.end());
  const ProgramResult result = run(words, no_drivers);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "backend: cpu, 1 threads (no OpenGL 4.3 was found; install")) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(read_json(folder / "sum.json")["backend"], "cpu");
}

TEST(CliBackend, TheCpuWithoutFramesLoadsNothingOfOpenGl) {
  const ProgramResult cpu = traced_run({"--backend", "cpu"});
  EXPECT_EQ(cpu.code, 0);
  EXPECT_FALSE(loaded_opengl(cpu));
  const ProgramResult gpu = traced_run({"--backend", "gpu"});
  EXPECT_EQ(gpu.code, 0);
  EXPECT_TRUE(loaded_opengl(gpu));
  EXPECT_EQ(run({"--backend", "cpu"}, no_drivers).code, 0);
}

TEST(CliBackend, ShadersOfTheUsersChangeTheRun) {
  const TemporaryFolder folder;
  const auto state = [&](const Words& more) {
    Words words{"--backend", "gpu", "--quiet", "--state", folder / "state.csv"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return read_file(folder / "state.csv");
  };
  const std::string plain = state({});
  EXPECT_EQ(state({}), plain);
  write_file(folder / "external.comp", "void run(uint i) { a_n[i] = vec2(0.0, 1.0); }\n");
  EXPECT_NE(state({"--shader-dir", folder.path.string()}), plain);
}

TEST(CliBackend, ShadersThatAreWrongAreBadInput) {
  const TemporaryFolder folder;
  const auto refusal = [&] {
    const ProgramResult result =
        run({"--backend", "gpu", "--shader-dir", folder.path.string(), "--state", folder / "state.csv"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(has(result.err, "sluice: --shader-dir: ")) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "state.csv"));
    return result.err;
  };
  EXPECT_TRUE(has(refusal(), "expected some of those in the folder shaders/"));
  write_file(folder / "external.comp", "void run(uint i) {\n  a_n[i] = gravity;\n}\n");
  EXPECT_TRUE(has(refusal(), (folder / "external.comp").string() + ":2: ")) << refusal();
  write_file(folder / "external.comp",
             "layout(std430) buffer v_block { vec2 v[]; };\nvoid run(uint i) { a_n[i] = v[i]; }\n");
  EXPECT_TRUE(has(refusal(), "has the storage block v_block")) << refusal();
}

}  // namespace
}  // namespace sluice::test
