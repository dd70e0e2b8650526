// Runs that are killed, interrupted or go bad, and disks that are full: the checkpoint that was there stays
// whole.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "apps/sluice/checkpoints.hpp"
#include "core/output/checkpoint.hpp"
#include "tests/support/checkpointed.hpp"
#include "tests/support/running_program.hpp"

namespace sluice::test {
namespace {

class CheckpointFailures : public CheckpointFolder {};

TEST(CheckpointClock, IsDueAtTheFirstStepThatReachesAMultiple) {
  const auto due = [](double every, double from, double dt, int steps) {
    app::CheckpointClock clock(every, from);
    std::vector<int> found;
    for (int step = 1; step <= steps; ++step)
      if (clock.advance(from + step * dt)) found.push_back(step);
    return found;
  };
  EXPECT_EQ(due(0.1, 0, 0.04, 10), (std::vector{3, 5, 8, 10}));
  EXPECT_EQ(due(0.1, 0.2, 0.04, 10), (std::vector{3, 5, 8, 10})) << "those up to the start are done";
  EXPECT_EQ(due(0.1, 0.16, 0.04, 5), (std::vector{1, 4}));
  EXPECT_EQ(due(0.01, 0, 0.04, 3), (std::vector{1, 2, 3})) << "several at once are one";
  EXPECT_EQ(due(0.45, 0, 0.15, 7), (std::vector{3, 6})) << "3 times 0.15 is less than 0.45 by a rounding";
  EXPECT_EQ(due(5e-324, 0, 0.04, 3), (std::vector{1, 2, 3}));
  EXPECT_EQ(due(1e300, 0, 0.04, 3), std::vector<int>{});
}

/// A number that changes whenever another file takes the name; 0 while there is none.
ino_t identity(const std::filesystem::path& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

void wait_until(RunningProgram& program, const auto& condition) {
  while (program.running() && !condition()) std::this_thread::yield();
}

bool is_writing(const std::filesystem::path& folder) {
  const Words names = names_in(folder);
  return std::ranges::any_of(names, [&](const std::string& name) {
    std::error_code gone;
    const auto size = std::filesystem::file_size(folder / name, gone);
    return name.ends_with(".tmp") && !gone && size > 0;
  });
}

TEST_F(CheckpointFailures, AKilledRunLeavesAWholeOne) {
  const auto path = folder / "a.ckp";
  Words words{"run", "breaking_dam", "--time",       "1e6", "--threads",          "1",   "--backend",
              "cpu", "--quiet",      "--checkpoint", path,  "--checkpoint-every", "0.04"};
  uint64_t last = 0;
  for (int round = 0; round < 12; ++round) {
    RunningProgram program(words);
    const ino_t before = identity(path);
    wait_until(program, [&] { return identity(path) != before; });
    if (round % 3 == 0) wait_until(program, [&] { return is_writing(folder.path); });
    if (round % 3 == 1) {
      for (int k = 0; k < round; ++k) {
        const ino_t now = identity(path);
        wait_until(program, [&] { return identity(path) != now; });
      }
    }
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().code, 128 + SIGKILL);
    const Checkpoint found = read_checkpoint(path);
    EXPECT_GT(found.state.clock.steps, last);
    last = found.state.clock.steps;
    words = {"run",       "--resume", path,      "--time",       "1e6", "--threads",          "1",
             "--backend", "cpu",      "--quiet", "--checkpoint", path,  "--checkpoint-every", "0.04"};
  }
  // Twelve runs that were killed are one that was not.
  const std::string end = std::to_string(last + 2);
  run({"--resume", "a.ckp", "--steps", end, "--backend", "cpu", "--state", "part.csv"});
  run({"breaking_dam", "--steps", end, "--backend", "cpu", "--state", "whole.csv"});
  EXPECT_TRUE(bytes("part.csv") == bytes("whole.csv")) << end;
}

// Frames up to a checkpoint are not drawn again: they have to be there before it is.
TEST_F(CheckpointFailures, AKilledRunLeavesItsFramesToo) {
  const auto path = folder / "a.ckp";
  RunningProgram program({"run", "breaking_dam", "--time", "1000", "--backend", "cpu", "--quiet", "--size",
                          "300x450", "--frames", folder / "f", "--checkpoint", path, "--checkpoint-every",
                          "0.2"});
  wait_until(program, [&] { return identity(path) != 0; });
  program.send(SIGKILL);
  program.wait();
  const uint64_t steps = read_checkpoint(path).state.clock.steps;  // a frame each, and the start
  for (uint64_t k = 0; k <= steps; ++k)
    EXPECT_TRUE(std::filesystem::exists(folder / fmt::format("f/frame_{:06}.png", k))) << k;
}

TEST_F(CheckpointFailures, AnInterruptLeavesOne) {
  for (const int signal : {SIGINT, SIGTERM}) {
    RunningProgram program({"run", "breaking_dam", "--time", "1e6", "--threads", "1", "--backend", "cpu",
                            "--checkpoint", folder / "a.ckp", "--series", folder / "s.csv", "--summary",
                            folder / "s.json"});
    wait_until(program, [&] { return is_writing(folder.path); });  // the series
    program.send(signal);
    const ProgramResult result = program.wait();
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(has(result.err, "interrupted after step ")) << result.err;
    const Checkpoint found = read_checkpoint(folder / "a.ckp");
    EXPECT_GT(found.state.clock.steps, 0u);
    EXPECT_EQ(found.state.clock.steps, read_json(folder / "s.json")["steps"]);
    EXPECT_EQ(names_in(folder.path), (Words{"a.ckp", "s.csv", "s.json"}));
    std::filesystem::remove(folder / "a.ckp");
  }
}

const Words exploding{"breaking_dam", "--set", "pressure.method=ssph", "--set", "pressure.ssph.stiffness=1e9",
                      "--backend",    "cpu"};

TEST_F(CheckpointFailures, AnInvalidRunKeepsTheLastGoodOne) {
  const std::string message =
      run(exploding + Words{"--checkpoint", "a.ckp", "--checkpoint-every", "0.01", "--summary", "s.json"}, 1);
  const uint64_t failed = read_json(folder / "s.json")["failure"]["step"];
  ASSERT_GT(failed, 2u);
  EXPECT_EQ(read_checkpoint(folder / "a.ckp").state.clock.steps, failed - 1);
  EXPECT_TRUE(has(
      message, "no checkpoint of an invalid state is written; a.ckp has step " + std::to_string(failed - 1)))
      << message;
  // One that was written by an earlier run stays as well.
  run(exploding + Words{"--steps", "2", "--checkpoint", "b.ckp"});
  const std::string before = bytes("b.ckp");
  EXPECT_TRUE(has(run({"--resume", "b.ckp", "--checkpoint", "b.ckp"}, 1), "b.ckp stays as it was"));
  EXPECT_TRUE(bytes("b.ckp") == before);
  EXPECT_EQ(names_in(folder.path), (Words{"a.ckp", "b.ckp", "s.json"}));
}

TEST_F(CheckpointFailures, AFolderThatIsNotThereIsKnownBeforeTheFirstStep) {
  const std::string message =
      run({"breaking_dam", "--time", "1e6", "--checkpoint", "missing/a.ckp", "--state", "s.csv"}, 3);
  EXPECT_TRUE(has(message, "missing/a.ckp") && has(message, "folder")) << message;
  EXPECT_TRUE(
      has(run({"breaking_dam", "--time", "1e6", "--checkpoint", "."}, 3), "name a file, not a folder"));
  EXPECT_EQ(names_in(folder.path), Words{});
}

TEST_F(CheckpointFailures, AFullDiskIsReportedAndTheRestIsWhole) {
  const std::string message = run({"breaking_dam", "--steps", "5", "--checkpoint", "/dev/full", "--state",
                                   "state.csv", "--series", "rows.csv", "--summary", "s.json"},
                                  3);
  EXPECT_TRUE(has(message, "/dev/full") && has(message, "free some space")) << message;
  EXPECT_EQ(read_table(folder / "state.csv").size(), 660u);
  EXPECT_EQ(read_table(folder / "rows.csv").size(), 5u);
  EXPECT_EQ(read_json(folder / "s.json")["steps"], 5);
  // On the way: what there is of the series is kept.
  run({"breaking_dam", "--steps", "9", "--checkpoint", "/dev/full", "--checkpoint-every", "0.12", "--series",
       "r.csv"},
      3);
  EXPECT_EQ(read_table(folder / "r.csv").size(), 3u);
}

/// The exit code of the program with these words in a shell that first does `before`, with `after` behind it.
int code_in_shell(const TemporaryFolder& folder, const std::string& before, const std::string& words,
                  const std::string& after) {
  const std::string command = fmt::format("cd '{}' && ({}; '{}' {} 2>message; echo $? >code) {}",
                                          folder.path.string(), before, SLUICE_BINARY, words, after);
  EXPECT_EQ(std::system(command.c_str()), 0);
  return std::stoi(read_file(folder / "code"));
}

TEST_F(CheckpointFailures, WhereThereIsNoRoomTheEarlierOneSurvives) {
  run({"breaking_dam", "--steps", "3", "--checkpoint", "a.ckp"});
  const std::string before = bytes("a.ckp");
  const std::string words =
      "run --resume a.ckp --steps 9 --quiet --checkpoint a.ckp --checkpoint-every 0.04 --series r.csv";
  // No file may be longer than a few blocks, as on a disk that is full but for them.
  EXPECT_EQ(code_in_shell(folder, "ulimit -f 8", words, ""), 3);
  EXPECT_TRUE(has(bytes("message"), "cannot write a.ckp: ")) << bytes("message");
  EXPECT_TRUE(bytes("a.ckp") == before);
  EXPECT_EQ(read_table(folder / "r.csv").size(), 1u);
  EXPECT_EQ(names_in(folder.path), (Words{"a.ckp", "code", "message", "r.csv"}));
}

TEST_F(CheckpointFailures, APipeTakesOneAndAClosedPipeIsReported) {
  const std::string words =
      "run breaking_dam --set particles.spacing=3 --steps 0 --quiet --checkpoint /dev/stdout ";
  EXPECT_EQ(code_in_shell(folder, ":", words + "--state s.csv", "| cat >a.ckp"), 0);
  EXPECT_EQ(read_checkpoint(folder / "a.ckp").state.x.size(), read_table(folder / "s.csv").size());
  // It is more than a pipe holds.
  ASSERT_GT(std::filesystem::file_size(folder / "a.ckp"), 70000u);
  std::filesystem::remove(folder / "s.csv");
  EXPECT_EQ(code_in_shell(folder, ":", words + "--state s.csv", "| true"), 3);
  EXPECT_TRUE(has(bytes("message"), "cannot write /dev/stdout: ")) << bytes("message");
  EXPECT_EQ(read_table(folder / "s.csv").size(), read_checkpoint(folder / "a.ckp").state.x.size());
}

}  // namespace
}  // namespace sluice::test
