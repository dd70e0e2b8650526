// The program as a process: interrupted, on a terminal, and without OpenGL where no picture is drawn.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Waits until a file in `folder`, under whatever name, holds bytes: the run is under way.
void wait_for_bytes(const std::filesystem::path& folder, RunningProgram& program) {
  while (program.running()) {
    for (const std::string& name : names_in(folder)) {
      std::error_code gone;
      const auto size = std::filesystem::file_size(folder / name, gone);
      if (!gone && size > 0) return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(CliProcess, AnInterruptEndsARunInOrder) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    RunningProgram program({"run", "breaking_dam", "--time", "1e6", "--threads", "1", "--backend", "cpu",
                            "--precision", "double", "--series", folder / "series.csv", "--state",
                            folder / "state.csv", "--summary", folder / "summary.json"});
    wait_for_bytes(folder.path, program);
    program.send(signal);
    const ProgramResult result = program.wait();
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(names_in(folder.path), (Words{"series.csv", "state.csv", "summary.json"}));
    const auto summary = read_json(folder / "summary.json");
    const Table series = read_table(folder / "series.csv");
    const uint64_t steps = summary["steps"];
    EXPECT_GT(steps, 0u);
    EXPECT_EQ(series.size(), steps);
    EXPECT_EQ(series.text(series.size() - 1, "step"), std::to_string(steps));
    EXPECT_EQ(summary["valid"], true);
    EXPECT_TRUE(has(result.err, "interrupted after step " + std::to_string(steps) + " of 25000000"))
        << result.err;
    EXPECT_TRUE(has(result.out, "Breaking dam: ")) << "the table of the end";
    // The state is that of the last row.
    double com = 0;
    for (const double y : read_table(folder / "state.csv").column("y")) com += y / 660;
    EXPECT_NEAR(com, series.column("com_y").back(), 1e-9);
  }
}

/// What the loader says while the program runs with these words.
std::string libraries(const Words& words) {
  RunningProgram program(words, {.environment = {"LD_DEBUG=files"}});
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result.err, "libepoxy")) << "the loader says nothing";
  return result.err;
}

TEST(CliProcess, WithoutPicturesThereIsNoOpenGL) {
  const TemporaryFolder folder;
  const Words run{"run",       "breaking_dam",
                  "--steps",   "3",
                  "--backend", "cpu",
                  "--threads", "1",
                  "--state",   folder / "state.csv",
                  "--series",  folder / "series.csv",
                  "--summary", folder / "summary.json"};
  const std::string without = libraries(run);
  for (const char* name :
       {"libEGL", "libGL.", "libGLX", "libGLdispatch", "libOpenGL", "libgallium", "swrast", "libLLVM"})
    EXPECT_FALSE(has(without, name)) << name;
  Words pictures = run;
  pictures.insert(pictures.end(), {"--frames", folder / "frames", "--size", "40x60"});
  EXPECT_TRUE(has(libraries(pictures), "libEGL")) << "with pictures there is";
}

/// The text of the terminal, its lines drawn over each other as separate lines.
std::string shown_on_terminal(Words words, unsigned short columns = 0) {
  words.insert(words.begin(),
               {"run", "breaking_dam", "--backend", "cpu", "--threads", "1", "--precision", "double"});
  RunningProgram program(words, {.environment = {}, .terminal = true, .columns = columns});
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 0);
  return result.err;
}

TEST(CliProcess, ATerminalSeesProgress) {
  const std::string number = "[0-9.e+-]+";
  const std::string text = shown_on_terminal({"--steps", "30"});
  const std::regex line("\r *[0-9]+ %  t " + number + "/1\\.2  " + number +
                        " steps/s  dt 0\\.04  iterations [0-9]+  " + "compression " + number +
                        "  left (under 1 s|[0-9]+ s)\x1b\\[K");
  EXPECT_TRUE(std::regex_search(text, line)) << text;
  EXPECT_TRUE(text.ends_with("\r\x1b[K")) << "the line is wiped at the end";
  EXPECT_FALSE(has(text, "\n")) << "it stays one line";
  EXPECT_TRUE(has(text, "\r  3 %  t 0.04/1.2 ")) << text;  // the first of 30 steps

  const std::string ssph = shown_on_terminal({"--steps", "30", "--set", "pressure.method=ssph"});
  EXPECT_TRUE(has(ssph, "dt 0.01  compression ")) << "no iterations where there are none: " << ssph;
  const std::string capped = shown_on_terminal(
      {"--steps", "3", "--set", "pressure.iisph.max_iterations=2", "--set", "pressure.iisph.tolerance=1e-6"});
  EXPECT_TRUE(std::regex_search(capped, std::regex("iterations 2  not converged [123]  "))) << capped;
}

// A line that is wrapped could not be written anew.
TEST(CliProcess, ProgressFitsIntoTheTerminal) {
  const std::string text = shown_on_terminal({"--steps", "30"}, 40);
  std::istringstream lines(text);
  size_t longest = 0;
  for (std::string line; std::getline(lines, line, '\r');)
    longest = std::max(longest, line.substr(0, line.find('\x1b')).size());
  EXPECT_EQ(longest, 40u) << text;
}

TEST(CliProcess, ProgressIsForTerminalsOnly) {
  EXPECT_EQ(shown_on_terminal({"--steps", "30", "--quiet"}), "");
  EXPECT_EQ(shown_on_terminal({"--steps", "0"}), "");
  const ProgramResult result =
      run_program({"run", "breaking_dam", "--backend", "cpu", "--threads", "1", "--steps", "30"});
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace sluice::test
