// `sluice play` on a display of its own (Xvfb), with somebody at its keys and mouse (xdotool).
#pragma once

#include <sys/types.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/running_program.hpp"

namespace sluice::test {

/// The bytes of a PNG file, which a failed comparison does not print.
struct Png {
  std::string bytes;
  friend bool operator==(const Png&, const Png&) = default;
  friend void PrintTo(const Png& png, std::ostream* out) {
    *out << "a picture of " << png.bytes.size() << " bytes";
  }
};

/// An X server without a screen.
class Display {
 public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  const std::string& name() const { return name_; }  ///< ":99"

 private:
  pid_t pid_ = -1;
  std::string name_;
};

class Played {
 public:
  /// Starts `sluice play` with these words in a folder of its own and waits for its window. Fails the test
  /// and throws when there is none after a minute.
  explicit Played(const std::vector<std::string>& words);

  void resize(uint32_t width, uint32_t height);
  /// Presses keys by their X names, one after the other: "space", "bracketleft".
  void press(const std::vector<std::string>& keys);
  /// Any other words for xdotool; returns what it says.
  std::string xdotool(const std::string& words) const;
  /// Fails the test when the window has not this size within a minute.
  void expect_size(uint32_t width, uint32_t height) const;

  /// Fails the test when the window's title is not this within a minute.
  void expect_title(const std::string& title) const;
  /// Waits until the program said this since the last call, and returns the rest of that line.
  std::string wait_for(const std::string& text);
  /// Presses s; the file and its bytes.
  struct Screenshot {
    std::string name;
    Png png;
  };
  Screenshot screenshot();

  /// Presses q and waits for the end.
  ProgramResult quit();

  TemporaryFolder folder;

 private:
  Display display_;
  std::unique_ptr<RunningProgram> program_;
  std::string window_;
  size_t heard_ = 0;  ///< of standard error
};

}  // namespace sluice::test
