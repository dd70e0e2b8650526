// Runs the program as a user would and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sluice::test {

struct ProgramResult {
  int code = -1;  ///< exit code; 128 + signal number when killed by one
  std::string out, err;
};

/// Runs `sluice` with these words (each one argument) in the folder `directory`.
ProgramResult run_program(const std::vector<std::string>& words,
                          const std::filesystem::path& directory = std::filesystem::current_path());

/// A fresh folder that disappears with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path / name; }

  std::filesystem::path path;
};

/// The whole file.
std::string read_file(const std::filesystem::path& path);

}  // namespace sluice::test
