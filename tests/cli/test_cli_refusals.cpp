// Values that an option can't take, scenes that can't be found or run: exit code 2, a message that names the
// option, and nothing written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A run that would write everything, with these words more; returns the message of its refusal.
std::string refusal(const Words& more, const std::string& scene = "breaking_dam") {
  const TemporaryFolder folder;
  Words words{"run",   scene,      "--threads", "1",         "--state",  "state.csv", "--series",
              "s.csv", "--frames", "frames",    "--summary", "sum.json", "--backend", "cpu"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words, folder.path);
  std::string line = scene;
  for (const std::string& word : more) line += ' ' + word;
  EXPECT_EQ(result.code, 2) << line << '\n' << result.err;
  EXPECT_EQ(result.out, "") << line;
  EXPECT_EQ(names_in(folder.path), std::vector<std::string>{}) << line;
  return result.err;
}

void expect_named(const std::string& option, const Words& values) {
  for (const std::string& value : values) {
    const std::string message = refusal({option, value});
    EXPECT_TRUE(has(message, option)) << message;
    EXPECT_LT(message.size(), 400u) << message;
  }
}

TEST(CliRefusals, Counts) {
  expect_named("--steps", {"-1", "1.5", "x", "1e3", "", " 3", "18446744073709551616", "nan"});
  expect_named("--gl-device", {"-1", "x", "1.5", ""});
  EXPECT_TRUE(has(refusal({"--gl-device", "200"}), "OpenGL device 200"));
  // In `refusal` there is a --threads already, so that a second is refused anyhow.
  for (const char* value : {"0", "-2", "x", "1.5", "1025", "4000000000", "nan", ""}) {
    const ProgramResult result = run_program({"run", "breaking_dam", "--steps", "1", "--threads", value});
    EXPECT_EQ(result.code, 2) << value;
    EXPECT_TRUE(has(result.err, "--threads: found \"")) << result.err;
  }
}

TEST(CliRefusals, Times) {
  expect_named("--time", {"-1", "x", "nan", "inf", "-inf", "1 s", "1e400", ""});
  EXPECT_TRUE(has(refusal({"--time", "1e300"}), "steps"));
  expect_named("--fps", {"0", "-25", "x", "nan", "inf", "25fps"});
}

// As from an unset variable of a shell.
TEST(CliRefusals, EmptyWords) {
  for (const char* option : {"--state", "--series", "--summary", "--frames", "--fps", "--colour", "--set"}) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run_program({"run", "breaking_dam", "--steps", "1", option, ""}, folder.path);
    EXPECT_EQ(result.code, 2) << option;
    EXPECT_TRUE(has(result.err, std::string(option).substr(2))) << result.err;
    EXPECT_EQ(names_in(folder.path), Words{}) << option;
  }
}

TEST(CliRefusals, StepsAndTimeTogether) {
  const std::string message = refusal({"--steps", "2", "--time", "1"});
  EXPECT_TRUE(has(message, "--steps") && has(message, "--time")) << message;
}

TEST(CliRefusals, Pictures) {
  expect_named("--size", {"0x0", "200", "200x", "x200", "200x300x4", "-200x300", "200X300", "200 x 300",
                          "15x16", "16x15", "16385x16", "99999999999x16", "1e2x100", ""});
  EXPECT_TRUE(has(refusal({"--colour", "red"}), "colour"));
  EXPECT_TRUE(has(refusal({"--colour", "red"}), "\"red\""));
  expect_named("--overlay", {"most", "Facts", ""});
}

TEST(CliRefusals, Choices) {
  expect_named("--precision", {"half", "single", "Double", ""});
  // --backend is there already, so that a second is refused by name as well.
  const ProgramResult backend = run_program({"run", "breaking_dam", "--steps", "1", "--backend", "tpu"});
  EXPECT_EQ(backend.code, 2);
  EXPECT_TRUE(has(backend.err, "--backend") && has(backend.err, "\"tpu\"") &&
              has(backend.err, "auto, cpu, gpu"))
      << backend.err;
  const ProgramResult both =
      run_program({"run", "breaking_dam", "--steps", "1", "--precision", "double", "--backend", "gpu"});
  EXPECT_EQ(both.code, 2);
  EXPECT_TRUE(has(both.err, "--precision double") && has(both.err, "--backend gpu")) << both.err;
}

TEST(CliRefusals, Overrides) {
  expect_named("--set", {"spacing", "=3", "particles.spacng=3", "particles.spacing=-1",
                         "fluid.rect.7.max=[1,2]", "time.dt=0", "pressure.method=sph"});
  EXPECT_TRUE(
      has(refusal({"--set", "time.dt=0.01", "--set", "particles.spacng=3"}), "--set particles.spacng"));
  // A further word is no second override but too many scenes.
  EXPECT_TRUE(has(refusal({"--set", "time.dt=0.01", "time.duration=3"}), "time.duration=3"));
}

TEST(CliRefusals, ScenesThatAreNotThere) {
  for (const char* scene : {"breaking_damn", "./breaking_dam.toml", "/nowhere/at/all.toml", "", "/"}) {
    const std::string message = refusal({}, scene);
    EXPECT_TRUE(has(message, scene)) << message;
  }
  EXPECT_TRUE(has(refusal({}, "breaking_damn"), "breaking_dam,")) << "the known names are listed";
  const ProgramResult info = run_program({"info", "breaking_damn"});
  EXPECT_EQ(info.code, 2);
  EXPECT_TRUE(has(info.err, "breaking_damn")) << info.err;
}

// Known only when the positions are relaxed, still before anything is written.
TEST(CliRefusals, AStartThatCannotBeRelaxed) {
  const std::string message = refusal({"--steps", "0", "--set", "fluid.jitter=0.5", "--set", "fluid.relax=20",
                                       "--set", "particles.rest_density=1e30"});
  EXPECT_TRUE(has(message, "fluid.relax")) << message;
}

// 480 million particles need more list entries than 32 bits count, whatever the machine has.
TEST(CliRefusals, ScenesThatAreTooLargeTakeNoMemory) {
  for (const char* spacing : {"0.01", "1e-3", "1e-9"}) {
    const TemporaryFolder folder;
    RunningProgram program({"run", "breaking_dam", "--set", std::string("particles.spacing=") + spacing,
                            "--steps", "0", "--state", folder / "state.csv"});
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_TRUE(has(result.err, "--set particles.spacing: ")) << result.err;
    EXPECT_LT(program.peak_memory(), 5e8) << spacing;
    EXPECT_EQ(names_in(folder.path), std::vector<std::string>{});
  }
  const ProgramResult result = run_program(
      {"run", "breaking_dam", "--set", "particles.spacing=0.01", "--steps", "0", "--threads", "1"});
  EXPECT_TRUE(has(result.err, "particles.spacing: found 0.01, ") && has(result.err, "GB")) << result.err;
}

}  // namespace
}  // namespace sluice::test
