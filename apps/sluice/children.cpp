// fork, and a temporary file for what a child has to say.
#include "apps/sluice/children.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>

#include "sluice/error.hpp"

namespace sluice::app {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Clock = std::chrono::steady_clock;
constexpr unsigned most_seconds = 3600;
using File = std::unique_ptr<std::FILE, Close>;

struct Child {
  size_t task = 0;
  File said;
  Clock::time_point start = Clock::now();
};

[[noreturn]] void fail(const char* what) {
  throw EnvironmentError(fmt::format("{} can't be made: {}; close other programs or use fewer --jobs", what,
                                     std::strerror(errno)));
}

/// Does the task and says what came of it; returns the exit code.
int act(const std::function<std::string(size_t)>& task, size_t i, std::FILE* said) {
  std::string text;
  int code = 0;
  try {
    text = task(i);
  } catch (const InputError& error) {
    text = error.what();
    code = 2;
  } catch (const std::exception& error) {
    text = error.what();
    code = 3;
  }
  const bool written = std::fwrite(text.data(), 1, text.size(), said) == text.size();
  return std::fflush(said) == 0 && written ? code : 3;
}

pid_t start(const std::function<std::string(size_t)>& task, size_t i, std::FILE* said) {
  std::fflush(nullptr);  // or both processes would write what is buffered
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail("a process");
  if (child > 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody is left to hear it
  if (getppid() != parent) _exit(3);
  alarm(most_seconds);  // SIGALRM ends what hangs
  _exit(act(task, i, said));
}

std::string all_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char part[4096];
  for (size_t read; (read = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, read);
  return text;
}

/// The end of any of the children, which is then one of them no more.
std::pair<size_t, ChildEnd> await(std::map<pid_t, Child>& children) {
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(-1, &status, 0);
    if (ended < 0 && errno != EINTR) fail("a wait for a process");
  } while (!children.contains(ended));
  const auto child = children.find(ended);
  ChildEnd end{all_of(child->second.said.get()), WIFEXITED(status) ? WEXITSTATUS(status) : 0,
               WIFSIGNALED(status) ? WTERMSIG(status) : 0,
               std::chrono::duration<double>(Clock::now() - child->second.start).count()};
  const size_t task = child->second.task;
  children.erase(child);
  return {task, std::move(end)};
}

}  // namespace

void in_children(size_t count, int jobs, const std::function<std::string(size_t)>& task,
                 const std::function<void(size_t, const ChildEnd&)>& done) {
  std::map<pid_t, Child> children;
  for (size_t next = 0; next < count || !children.empty();) {
    if (next < count && children.size() < static_cast<size_t>(jobs)) {
      File said(std::tmpfile());
      if (!said) fail("a temporary file");
      const pid_t child = start(task, next, said.get());
      children.emplace(child, Child{next++, std::move(said), Clock::now()});
      continue;
    }
    const auto [ended, end] = await(children);
    done(ended, end);
  }
}

}  // namespace sluice::app
