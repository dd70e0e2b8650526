// `sluice study`: what it writes, what it says, and its exit codes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/running_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(CliStudy, WhatIsNoStudyIsAnsweredWithThoseThereAre) {
  for (const Words& words : {Words{"study"}, {"study", "table_6_1", "--out", "out"}}) {
    const TemporaryFolder folder;
    const ProgramResult result = run_program(words, folder.path);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(has(result.err, "hard ") && has(result.err, words.size() > 1 ? words[1] : "no name"))
        << result.err;
    EXPECT_TRUE(names_in(folder.path).empty());
  }
}

TEST(CliStudy, WordsThatMeanNothingAreRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](Words words) {
    words.insert(words.begin(), {"study", "hard"});
    const ProgramResult result = run_program(words, folder.path);
    EXPECT_EQ(result.code, 2);
    return result.err;
  };
  EXPECT_TRUE(has(refusal({}), "--out"));
  EXPECT_TRUE(has(refusal({"--out", "out", "--jobs", "0"}), "--jobs"));
  EXPECT_TRUE(has(refusal({"--out", "out", "--only", "bogus"}), "bogus"));
  EXPECT_TRUE(has(refusal({"--out", "out", "--quick", "--only", "tank_at_rest"}), "a quick case"));
  EXPECT_TRUE(has(refusal({"--out", "out", "--collect", "out"}), "--collect"));
  EXPECT_TRUE(names_in(folder.path).empty());
}

TEST(CliStudy, WritesTheTableAndScenesThatRunAlike) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(
      {"study", "hard", "--out", "out", "--only", "two_particles_free_iisph", "--jobs", "2"}, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(names_in(folder / "out"), (Words{"hard.csv", "hard.md", "scenes"}));
  EXPECT_EQ(names_in(folder.path / "out" / "scenes"), (Words{"two_particles_free_iisph.toml"}));
  EXPECT_EQ(read_file(folder.path / "out" / "hard.md"), result.out);
  EXPECT_TRUE(has(result.out, "| case | method | backend | warned |")) << result.out;
  EXPECT_TRUE(has(result.out, "\n1 cases on the CPU and on ")) << result.out;

  const Words rows = lines_of(read_file(folder.path / "out" / "hard.csv"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[0].starts_with("case,method,backend,"));
  EXPECT_TRUE(rows[1].starts_with("two_particles_free_iisph,IISPH,cpu,no,survived,0.04,75,"));
  EXPECT_TRUE(rows[2].starts_with("two_particles_free_iisph,IISPH,gpu,no,survived,0.04,75,"));

  ASSERT_EQ(run_program({"run", "out/scenes/two_particles_free_iisph.toml", "--backend", "cpu", "--quiet",
                         "--summary", "run.json"},
                        folder.path)
                .code,
            0);
  EXPECT_EQ(read_json(folder / "run.json")["steps"], 75);
}

TEST(CliStudy, ListsTheRunsAndWritesTheirScenes) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"study", "hard", "--out", "out", "--list"}, folder.path);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(names_in(folder / "out"), (Words{"scenes"}));
  const Words lines = lines_of(result.out);
  EXPECT_EQ(std::ranges::count(lines, "# pairs_at_0_iisph: rearranged, runs only in the study"), 1);
  EXPECT_GT(lines.size(), 300u);
  const auto line = std::ranges::find_if(
      lines, [](const std::string& text) { return has(text, "velocity_1e30_ssph.toml --backend cpu"); });
  ASSERT_NE(line, lines.end());
  std::istringstream stream(*line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  ASSERT_EQ(words.front(), "sluice");
  words.erase(words.begin());
  EXPECT_EQ(run_program(words, folder.path).code, 1);
  EXPECT_EQ(read_json(folder.path / "out" / "velocity_1e30_ssph_cpu.json")["failure"]["step"], 1);
}

/// Each line of a list, in this shell's program.
void run_lines(const std::string& list, const std::filesystem::path& folder) {
  for (const std::string& line : lines_of(list)) {
    const std::string command = "cd '" + folder.string() + "' && '" SLUICE_BINARY "'" + line.substr(6);
    ASSERT_EQ(std::system(command.c_str()), 0) << line;
  }
}

// However the runs were made, the tables are the same.
TEST(CliStudy, CollectsWhatTheLinesOfItsListLeave) {
  const TemporaryFolder folder;
  const Words these{"study", "density", "--only", "for_pressure"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), these.begin(), these.end());
    return run_program(more, folder.path);
  };
  const ProgramResult list = with({"--out", "one", "--list"});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_EQ(lines_of(list.out).size(), 1u);
  run_lines(list.out, folder.path);
  const ProgramResult collected = with({"--collect", "one"});
  EXPECT_EQ(collected.code, 0) << collected.err;
  const ProgramResult direct = with({"--out", "two", "--jobs", "2"});
  EXPECT_EQ(direct.code, 0) << direct.err;
  EXPECT_EQ(collected.out, direct.out);
  EXPECT_EQ(names_in(folder.path / "one"),
            (Words{"density.csv", "density.md", "density_verdicts.csv", "density_windows.csv", "runs"}));
  for (const char* name : {"density.csv", "density.md", "density_verdicts.csv", "density_windows.csv"})
    EXPECT_EQ(read_file(folder.path / "one" / name), read_file(folder.path / "two" / name));
  EXPECT_EQ(read_table(folder.path / "one" / "density.csv").size(), 1000u);
}

TEST(CliStudy, CollectsWhatIsThereAndSaysWhatIsNot) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"study", "density", "--only", "for_pressure", "--out", "out"}, folder.path).code, 0);
  const ProgramResult result =
      run_program({"study", "density", "--collect", "out", "--out", "tables"}, folder.path);
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result.err, "5 of 6 results are not there")) << result.err;
  EXPECT_EQ(names_in(folder.path / "tables"),
            (Words{"density.csv", "density.md", "density_verdicts.csv", "density_windows.csv"}));

  const ProgramResult none = run_program({"study", "cost", "--collect", "out"}, folder.path);
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(has(none.err, "study cost --out out --list")) << none.err;
  EXPECT_EQ(run_program({"study", "density", "--list", "--collect", "out"}, folder.path).code, 2);
}

// A result that is no good is named, and the others make the tables.
TEST(CliStudy, CollectsBesideWhatIsNoGood) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"study", "density", "--only", "iisph_", "--out", "out"}, folder.path).code, 0);
  std::ofstream(folder.path / "out" / "runs" / "iisph_recommended.csv") << "step,time\n";
  const ProgramResult result = run_program({"study", "density", "--collect", "out"}, folder.path);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result.err, "iisph_recommended.csv: found no step")) << result.err;
  EXPECT_TRUE(has(result.out, "IISPH, for pressure")) << result.out;
  EXPECT_FALSE(has(result.out, "IISPH, recommended")) << result.out;
}

// What an earlier study left is not taken for a result of this one.
TEST(CliStudy, APointThatCannotRunLeavesNoResult) {
  const TemporaryFolder folder;
  const Words words{"study", "density", "--only", "for_pressure", "--out", "out"};
  ASSERT_EQ(run_program(words, folder.path).code, 0);
  const std::filesystem::path runs = folder.path / "out" / "runs";
  std::filesystem::remove(runs / "iisph_for_pressure.csv");
  std::filesystem::create_directories(runs / "iisph_for_pressure.csv" / "in_the_way");
  const ProgramResult result = run_program(words, folder.path);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result.err, "iisph_for_pressure: failed: ")) << result.err;
  EXPECT_EQ(names_in(runs), (Words{"iisph_for_pressure.csv"}));
}

// A million particles take more than a second of a processor's time: the case is killed, not the study.
TEST(CliStudy, NamesACaseThatCrashed) {
  const TemporaryFolder folder;
  const std::string command = "cd '" + folder.path.string() +
                              "' && ulimit -c 0 && ulimit -t 1 && '" SLUICE_BINARY
                              "' study hard --out out --only crowd_of_1000000 >out.md 2>err";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string err = read_file(folder / "err");
  EXPECT_TRUE(has(err, "crowd_of_1000000_in_8_ssph on cpu did not come out as expected: crashed with signal"))
      << err;
  EXPECT_TRUE(has(read_file(folder.path / "out" / "hard.csv"), "crashed with signal"));
}

TEST(CliStudy, WithoutOpenGlItSaysSo) {
  const TemporaryFolder folder;
  RunningProgram::Options options;
  options.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"};
  RunningProgram program({"study", "hard", "--out", folder / "out", "--quick"}, options);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(has(result.err, "OpenGL")) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace sluice::test
