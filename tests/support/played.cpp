#include "tests/support/played.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace sluice::test {
namespace {

using namespace std::chrono_literals;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Calls until it says true; false after a minute.
template <class Condition>
bool within_a_minute(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + 60s;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(20ms);
  }
  return true;
}

std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[256];
  while (fgets(part, sizeof part, pipe) != nullptr) text += part;
  pclose(pipe);
  return text;
}

}  // namespace

Display::Display() {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  // A number of its own: a server that looks for a free one may take that of another that is just going away,
  // and lose its socket with it. No reset, which is due whenever the last client leaves, as each xdotool
  // does.
  const std::string number = fmt::format(":{}", 100 + getpid() % 50000), descriptor = std::to_string(ends[1]);
  std::vector<std::string> words{"Xvfb", number, "-displayfd", descriptor, "-noreset"};
  words.insert(words.end(), {"-screen", "0", "1280x1024x24", "-nolisten", "tcp"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int failed = posix_spawnp(&pid_, "Xvfb", &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  close(ends[1]);
  pollfd ready{ends[0], POLLIN, 0};
  char digits[16] = {};
  const bool there =
      failed == 0 && poll(&ready, 1, 60'000) == 1 && read(ends[0], digits, sizeof digits - 1) > 0;
  close(ends[0]);
  if (!there) {
    if (failed == 0) kill(pid_, SIGTERM);
    throw std::runtime_error("no Xvfb; install the package xvfb");
  }
  name_ = number;
}

Display::~Display() {
  if (pid_ <= 0) return;
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
}

Played::Played(const std::vector<std::string>& words) {
  std::vector<std::string> all{"play"};
  all.insert(all.end(), words.begin(), words.end());
  program_ = std::make_unique<RunningProgram>(
      all, RunningProgram::Options{.environment = {"DISPLAY=" + display_.name()}, .directory = folder.path});
  const bool there = within_a_minute([&] {
    window_ = first_line(xdotool("search --name Sluice"));
    return !window_.empty() || !program_->running();
  });
  if (!there || window_.empty())
    throw std::runtime_error("no window (xdotool is in the package xdotool): " + program_->errors_so_far());
  // What it shows has a title of its own, once it is shown.
  if (!within_a_minute(
          [&] { return xdotool(fmt::format("getwindowname {}", window_)).find(" – ") != std::string::npos; }))
    throw std::runtime_error("the window stays empty");
  const bool focused = within_a_minute([&] {
    xdotool("windowfocus " + window_);
    return first_line(xdotool("getwindowfocus")) == window_;
  });
  if (!focused) throw std::runtime_error("the window can't be given the keyboard");
}

std::string Played::xdotool(const std::string& words) const {
  return output_of(fmt::format("DISPLAY={} xdotool {} 2>/dev/null", display_.name(), words));
}

void Played::resize(uint32_t width, uint32_t height) {
  xdotool(fmt::format("windowsize --sync {} {} {}", window_, width, height));
}

void Played::press(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) xdotool("key " + key);
}

void Played::expect_size(uint32_t width, uint32_t height) const {
  const std::string wanted = fmt::format("{}x{}", width, height);
  EXPECT_TRUE(within_a_minute([&] {
    return xdotool(fmt::format("getwindowgeometry {}", window_)).find(wanted) != std::string::npos;
  })) << "the window never had "
      << wanted;
}

void Played::expect_title(const std::string& title) const {
  std::string found;
  const bool there = within_a_minute(
      [&] { return (found = first_line(xdotool(fmt::format("getwindowname {}", window_)))) == title; });
  EXPECT_TRUE(there) << "the title is " << found << ", expected " << title;
}

std::string Played::wait_for(const std::string& text) {
  std::string said;
  size_t at = said.npos;
  const bool heard = within_a_minute([&] {
    said = program_->errors_so_far();
    at = said.find(text, heard_);
    return at != said.npos && said.find('\n', at) != said.npos;
  });
  if (!heard) {
    ADD_FAILURE() << "waited for \"" << text << "\", it said:\n" << said.substr(heard_);
    throw std::runtime_error("no answer");
  }
  heard_ = said.find('\n', at) + 1;
  return first_line(said.substr(at + text.size()));
}

Played::Screenshot Played::screenshot() {
  press({"s"});
  const std::string name = wait_for("sluice: screenshot ");
  return {name, {read_file(folder / name)}};
}

ProgramResult Played::quit() {
  press({"q"});
  return program_->wait();
}

}  // namespace sluice::test
