// The program while it runs: to interrupt it, to give it a terminal or an environment, to see what it took.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace sluice::test {

class RunningProgram {
 public:
  struct Options {
    std::vector<std::string> environment;  ///< further variables, each NAME=VALUE
    bool terminal = false;                 ///< standard error is a terminal
    unsigned short columns = 0;            ///< of the terminal; 0: it does not say
    std::filesystem::path directory = std::filesystem::current_path();
  };

  /// Starts `sluice` with these words; standard input is empty.
  explicit RunningProgram(const std::vector<std::string>& words, const Options& options);
  explicit RunningProgram(const std::vector<std::string>& words) : RunningProgram(words, Options{}) {}
  ~RunningProgram();  ///< kills it if it still runs
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  bool running();
  void send(int signal);
  /// What it wrote to standard error so far, which is no terminal.
  std::string errors_so_far() const { return read_file(streams_ / "err"); }

  /// Waits for its end and returns what it said; what a terminal showed is in `err`.
  ProgramResult wait();

  /// Most memory it held, in bytes; known after wait().
  double peak_memory() const { return peak_memory_; }

 private:
  std::string read_terminal() const;

  TemporaryFolder streams_;
  pid_t pid_ = -1;
  int terminal_ = -1;
  int status_ = 0;
  double peak_memory_ = 0;
};

}  // namespace sluice::test
