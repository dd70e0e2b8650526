// The command line of `sluice`.
#pragma once

#include <string>
#include <vector>

#include "apps/sluice/options.hpp"

namespace sluice::app {

/// Exit codes; 0 is done, 1 an invalid run or a disagreement.
inline constexpr int bad_input = 2, environment_failed = 3;

/// Prints "sluice: MESSAGE" to standard error and returns `code`.
int fail(int code, const std::string& message);

/// Runs the subcommand that the command line names; returns its exit code. Throws what the command throws,
/// and InputError for an option whose value is wrong.
int run_command_line(int argc, char** argv);

/// Options of `sluice run WORDS...`. Throws InputError, or an exception of the parser.
RunOptions run_options_of(std::vector<std::string> words);

}  // namespace sluice::app
