// Places that can't be written: exit code 3, the place and the reason named, nothing half written left
// behind.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/output/output_file.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Exit code 3 within `folder`; returns the message.
std::string failure(const Words& more, const TemporaryFolder& folder) {
  Words words{"run", "breaking_dam", "--steps", "5", "--threads", "1", "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_program(words, folder.path);
  EXPECT_EQ(result.code, 3) << more.back() << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("sluice: ")) << result.err;
  return result.err;
}

TEST(CliFailedOutputs, AFolderThatIsNotThere) {
  for (const std::string option : {"--state", "--series", "--summary"}) {
    const TemporaryFolder folder;
    Words words;
    for (const std::string other : {"--state", "--series", "--summary"})
      words.insert(words.end(), {other, (other == option ? "missing/" : "") + other.substr(2)});
    words.insert(words.end(), {"--frames", "frames"});
    const std::string message = failure(words, folder);
    EXPECT_TRUE(has(message, "missing/" + option.substr(2)) && has(message, "folder")) << message;
    EXPECT_EQ(names_in(folder.path), Words{}) << option;
  }
}

TEST(CliFailedOutputs, AFullDisk) {
  for (const std::string option : {"--state", "--series", "--summary"}) {
    const TemporaryFolder folder;
    Words words;
    for (const std::string other : {"--state", "--series", "--summary"})
      words.insert(words.end(), {other, other == option ? "/dev/full" : other.substr(2)});
    const std::string message = failure(words, folder);
    EXPECT_TRUE(has(message, "/dev/full") && has(message, "free some space")) << message;
    const Words names = names_in(folder.path);  // the others are whole
    EXPECT_EQ(names.size(), 2u);
    for (const std::string& name : names) {
      if (name == "summary") {
        EXPECT_EQ(nlohmann::json::parse(read_file(folder / name)).at("steps"), 5);
      } else {
        EXPECT_EQ(read_table(folder / name).size(), name == "state" ? 660u : 5u) << name;
      }
    }
  }
}

TEST(CliFailedOutputs, AnOlderFileStaysAsItWasOrIsReplacedByAWholeOne) {
  const TemporaryFolder folder;
  write_file(folder / "state.csv", "old");
  failure({"--state", "state.csv", "--frames", "state.csv/frames"}, folder);  // before the run
  EXPECT_EQ(read_file(folder / "state.csv"), "old");
  EXPECT_EQ(names_in(folder.path), Words{"state.csv"});
  failure({"--state", "state.csv", "--series", "/dev/full"}, folder);  // after it
  EXPECT_EQ(read_table(folder / "state.csv").size(), 660u);
  EXPECT_EQ(names_in(folder.path), Words{"state.csv"});
}

TEST(CliFailedOutputs, FramesThatCannotBeAFolder) {
  const TemporaryFolder folder;
  write_file(folder / "file", "a file");
  for (const char* frames : {"file", "file/frames"}) {
    const std::string message = failure({"--frames", frames, "--state", "state.csv"}, folder);
    EXPECT_TRUE(has(message, std::string(frames) + ": ") && has(message, "--frames")) << message;
    EXPECT_EQ(names_in(folder.path), Words{"file"});
    EXPECT_EQ(read_file(folder / "file"), "a file");
  }
}

TEST(CliFailedOutputs, AFrameThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "frames/frame_000003.png/in_the_way");
  const std::string message = failure({"--frames", "frames", "--size", "40x60"}, folder);
  EXPECT_TRUE(has(message, "frames/frame_000003.png")) << message;
  for (const std::string& name : names_in(folder / "frames")) EXPECT_TRUE(name.starts_with("frame_")) << name;
}

}  // namespace
}  // namespace sluice::test
