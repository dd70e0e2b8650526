// The errors a user can meet. A message says what is wrong, where, and what to do about it.
#pragma once

#include <stdexcept>
#include <string>

namespace sluice {

/// Base of all errors that are reported by message, without a stack trace.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bad input: a scene file, a --set override or the command line. Exit code 2.
class InputError : public Error {
 public:
  using Error::Error;
};

/// The surroundings failed: no OpenGL, a full disk, a folder that can't be written. Exit code 3.
class EnvironmentError : public Error {
 public:
  using Error::Error;
};

}  // namespace sluice
