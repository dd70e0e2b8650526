// Runs of the program in a folder of their own, whole and in parts.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/run_program.hpp"
#include "tests/support/table.hpp"

namespace sluice::test {

using namespace study;

using Words = std::vector<std::string>;

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class CheckpointFolder : public testing::Test {
 protected:
  /// The message of a quiet run on one thread that ends with this code.
  std::string run(const Words& words, int code = 0) {
    const ProgramResult result = run_program(Words{"run", "--quiet", "--threads", "1"} + words, folder.path);
    std::string line;
    for (const std::string& word : words) line += ' ' + word;
    EXPECT_EQ(result.code, code) << line << '\n' << result.err;
    return result.err;
  }
  std::string bytes(const std::string& name) const { return read_file(folder / name); }

  TemporaryFolder folder;
};

}  // namespace sluice::test
