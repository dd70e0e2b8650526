// Words of the command line: what they answer, where they answer it and with which exit code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/output/summary.hpp"
#include "sluice/version.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CliUsage, HelpAndVersionAreAnswers) {
  for (const Words& words : {Words{"--help"}, {"-h"}, {"run", "--help"}, {"scenes", "--help"}}) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.code, 0) << words.front();
    EXPECT_TRUE(has(result.out, "Usage: ")) << words.front();
    EXPECT_EQ(result.err, "") << words.front();
  }
  const ProgramResult result = run_program({"--version"});
  EXPECT_EQ(result.code, 0);
  const std::string of_commit = commit().empty() ? "" : " (commit " + commit() + ")";
  EXPECT_EQ(result.out, "sluice " + version() + of_commit + "\n");
  EXPECT_EQ(result.err, "");
}

/// Exit code 2, nothing on standard output, nothing in the folder; returns the message.
std::string refusal(const Words& words) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(words, folder.path);
  std::string line;
  for (const std::string& word : words) line += word + ' ';
  EXPECT_EQ(result.code, 2) << line << result.err;
  EXPECT_EQ(result.out, "") << line;
  EXPECT_TRUE(result.err.starts_with("sluice: ")) << line << result.err;
  EXPECT_EQ(names_in(folder.path), std::vector<std::string>{}) << line;
  return result.err;
}

TEST(CliUsage, WordsThatMeanNothingAreRefused) {
  EXPECT_TRUE(has(refusal({}), "subcommand"));
  for (const char* word : {"bogus", "--bogus", "Run"}) EXPECT_TRUE(has(refusal({word}), word)) << word;
  EXPECT_TRUE(has(refusal({"run"}), "SCENE"));
  EXPECT_TRUE(has(refusal({"run", "breaking_dam", "--steps", "1", "--stats", "s.csv"}), "--stats"));
  EXPECT_TRUE(has(refusal({"run", "breaking_dam", "resting_fluid", "--steps", "1"}), "resting_fluid"));
  EXPECT_TRUE(has(refusal({"scenes", "breaking_dam"}), "breaking_dam"));
  EXPECT_TRUE(has(refusal({"info", "breaking_dam", "more"}), "more"));
}

TEST(CliUsage, ResultsAreOnStandardOutputMessagesOnStandardError) {
  const TemporaryFolder folder;
  const ProgramResult chosen =
      run_program({"run", "breaking_dam", "--steps", "3", "--threads", "1"}, folder.path);
  EXPECT_EQ(chosen.code, 0);
  EXPECT_TRUE(has(chosen.out, "Breaking dam: 3 steps of IISPH")) << chosen.out;
  EXPECT_TRUE(has(chosen.out, "pressure_operator")) << chosen.out;
  // `auto` says what it took and why; no progress, as this is no terminal.
  EXPECT_TRUE(has(chosen.err, "backend: cpu, 1 threads (below about 20000 particles")) << chosen.err;
  EXPECT_EQ(std::count(chosen.err.begin(), chosen.err.end(), '\n'), 1) << chosen.err;

  const ProgramResult named =
      run_program({"run", "breaking_dam", "--steps", "3", "--threads", "1", "--backend", "cpu"}, folder.path);
  EXPECT_EQ(named.code, 0);
  EXPECT_NE(named.out, "");
  EXPECT_EQ(named.err, "");

  const ProgramResult quiet =
      run_program({"run", "breaking_dam", "--steps", "3", "--threads", "1", "--quiet"}, folder.path);
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(names_in(folder.path), std::vector<std::string>{});  // nothing that was not asked for
}

TEST(CliUsage, AStandardOutputThatIsFullIsAFailure) {
  for (const char* words : {"scenes", "run breaking_dam --steps 1 --backend cpu"}) {
    const std::string command = std::string(SLUICE_BINARY) + ' ' + words + " >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3) << words;
  }
}

}  // namespace
}  // namespace sluice::test
