// What an action is refused with.
#pragma once

#include <string>

#include "sluice/error.hpp"

namespace sluice::test {

/// The message of the Kind of error that it throws; "no such error" when it throws none.
template <class Kind = EnvironmentError>
std::string message_of(const auto& action) {
  try {
    action();
  } catch (const Kind& error) {
    return error.what();
  }
  return "no such error";
}

}  // namespace sluice::test
