#include "tests/support/running_program.hpp"

#include <fcntl.h>
#include <pty.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <stdexcept>

namespace sluice::test {
namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& words, const Options& options) {
  std::vector<std::string> arguments{SLUICE_BINARY}, environment = options.environment;
  arguments.insert(arguments.end(), words.begin(), words.end());
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string known = *variable, name = known.substr(0, known.find('=') + 1);
    const bool replaced = std::ranges::any_of(options.environment,
                                              [&](const std::string& own) { return own.starts_with(name); });
    if (!replaced) environment.push_back(known);
  }

  const std::string out = streams_ / "out", err = streams_ / "err";
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&files, options.directory.c_str());
  int slave = -1;
  if (options.terminal) {
    winsize size{};
    size.ws_col = options.columns;
    if (openpty(&terminal_, &slave, nullptr, nullptr, &size) != 0)
      throw std::runtime_error("no pseudo-terminal");
    posix_spawn_file_actions_adddup2(&files, slave, STDERR_FILENO);
    posix_spawn_file_actions_addclose(&files, slave);
    posix_spawn_file_actions_addclose(&files, terminal_);
  } else {
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  }
  const int failed = posix_spawn(&pid_, SLUICE_BINARY, &files, nullptr, pointers(arguments).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&files);
  if (slave >= 0) close(slave);
  if (failed != 0) throw std::runtime_error("can't start " SLUICE_BINARY);
}

RunningProgram::~RunningProgram() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (terminal_ >= 0) close(terminal_);
}

bool RunningProgram::running() {
  siginfo_t end{};
  return pid_ > 0 && waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         end.si_pid == 0;
}

void RunningProgram::send(int signal) {
  if (pid_ > 0) kill(pid_, signal);
}

ProgramResult RunningProgram::wait() {
  ProgramResult result;
  if (terminal_ >= 0) result.err = read_terminal();
  rusage used{};
  while (pid_ > 0 && wait4(pid_, &status_, 0, &used) < 0 && errno == EINTR) continue;
  pid_ = -1;
  peak_memory_ = 1024.0 * static_cast<double>(used.ru_maxrss);
  result.code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  result.out = read_file(streams_ / "out");
  if (terminal_ < 0) result.err = read_file(streams_ / "err");
  return result;
}

/// Everything until the program closes its side, which reads as an error.
std::string RunningProgram::read_terminal() const {
  std::string text;
  char part[4096];
  for (;;) {
    const ssize_t count = read(terminal_, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part, static_cast<size_t>(count));
  }
}

}  // namespace sluice::test
