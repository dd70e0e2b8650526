// Output files are whole or absent, and no failure passes silently.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "core/output/output_file.hpp"
#include "sluice/error.hpp"
#include "tests/support/synced.hpp"

namespace {

namespace fs = std::filesystem;
using sluice::EnvironmentError;
using sluice::OutputFile;
using sluice::write_file;

class OutputFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "sluice-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  size_t files() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  fs::path folder;
};

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string message_of(const fs::path& path, const std::string& bytes = "x") {
  try {
    write_file(path, bytes);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(OutputFileTest, WritesAllBytesAndLeavesNothingElse) {
  std::string bytes(300'001, '\0');
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 131 + (i >> 8));
  write_file(folder / "a", bytes);
  EXPECT_TRUE(read(folder / "a") == bytes);
  EXPECT_EQ(files(), 1u);
  write_file(folder / "a", "");
  EXPECT_EQ(fs::file_size(folder / "a"), 0u);
}

TEST_F(OutputFileTest, PartsArriveInOrder) {
  OutputFile file(folder / "rows.csv");
  std::string expected;
  for (int row = 0; row < 30'000; ++row) {
    const std::string line = std::to_string(row) + ",\n";
    expected += line;
    file.write(line);
  }
  EXPECT_FALSE(fs::exists(folder / "rows.csv"));
  file.commit();
  EXPECT_TRUE(read(folder / "rows.csv") == expected);
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStays) {
  write_file(folder / "a", "old");
  {
    OutputFile file(folder / "a");
    file.write(std::string(200'000, 'n'));
    EXPECT_EQ(files(), 2u);
    OutputFile moved = std::move(file);
    moved.write("more");
  }
  EXPECT_EQ(read(folder / "a"), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, WritingAfterCommitIsRefused) {
  OutputFile file(folder / "a");
  file.write("one");
  file.commit();
  file.write("two");
  EXPECT_THROW(file.commit(), sluice::Error);
  EXPECT_EQ(read(folder / "a"), "one");
}

TEST_F(OutputFileTest, AFullDiskIsReported) {
  for (const size_t size : {size_t{1}, size_t{1} << 16, size_t{1} << 20}) {
    const std::string message = message_of("/dev/full", std::string(size, 'x'));
    EXPECT_TRUE(contains(message, "/dev/full")) << message;
    EXPECT_TRUE(contains(message, "No space left")) << message;
    EXPECT_TRUE(contains(message, "free some space")) << message;
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(OutputFileTest, AMissingFolderIsReported) {
  const std::string message = message_of(folder / "nowhere" / "a.csv");
  EXPECT_TRUE(contains(message, (folder / "nowhere" / "a.csv").string())) << message;
  EXPECT_TRUE(contains(message, "No such file or directory")) << message;
  EXPECT_TRUE(contains(message, "create its folder")) << message;
}

TEST_F(OutputFileTest, AFolderOrNoNameIsRefused) {
  EXPECT_TRUE(contains(message_of(folder), "name a file, not a folder"));
  EXPECT_TRUE(contains(message_of(folder / "new" / ""), "name a file, not a folder"));
  EXPECT_TRUE(contains(message_of(""), "without a name"));
  EXPECT_TRUE(contains(message_of(folder / std::string(300, 'n')), "shorter name"));
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFileTest, TheLongestNameWorks) {
  const fs::path path = folder / std::string(255, 'n');
  write_file(path, "x");
  EXPECT_EQ(read(path), "x");
}

TEST_F(OutputFileTest, ALinkKeepsPointingAndItsTargetIsRewritten) {
  fs::create_directory(folder / "data");
  write_file(folder / "data" / "real", "old");
  fs::create_symlink("data/real", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read(folder / "data" / "real"), "new");
}

TEST_F(OutputFileTest, PermissionsOfTheOldFileStay) {
  write_file(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0640));
  write_file(folder / "a", "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, APipeIsWrittenNotReplaced) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read(pipe); });
  const std::string bytes(200'000, 'p');
  write_file(pipe, bytes);
  reader.join();
  EXPECT_TRUE(received == bytes);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(OutputFileTest, AnOpenDescriptorGoesOnWhereItIs) {
  const fs::path log = folder / "log";
  const int descriptor = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ASSERT_GE(descriptor, 0);
  ASSERT_EQ(write(descriptor, "before ", 7), 7);
  write_file("/dev/fd/" + std::to_string(descriptor), "between ");
  ASSERT_EQ(write(descriptor, "after", 5), 5);
  close(descriptor);
  EXPECT_EQ(read(log), "before between after");
  EXPECT_TRUE(contains(message_of("/dev/fd/" + std::to_string(descriptor)), "Bad file descriptor"));
}

TEST_F(OutputFileTest, IsOnTheDiskBeforeItHasItsNameAndItsNameIsToo) {
  const sluice::test::SyncListener listener(folder / "a");
  OutputFile file(folder / "a");
  const fs::path temporary = file.temporary();
  file.write("bytes");
  file.commit_to_disk();
  const auto& found = listener.heard;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].path, temporary);
  EXPECT_FALSE(found[0].named);
  EXPECT_EQ(found[1].path, folder);
  EXPECT_TRUE(found[1].named);
  EXPECT_EQ(read(folder / "a"), "bytes");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, WhatHasNoDiskHasNothingToWaitFor) {
  OutputFile nothing("/dev/null");
  nothing.write("bytes");
  EXPECT_NO_THROW(nothing.commit_to_disk());
  OutputFile full("/dev/full");
  full.write("bytes");
  EXPECT_THROW(full.commit_to_disk(), EnvironmentError);
}

}  // namespace
