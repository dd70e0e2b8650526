// What TOML text needs before the parser (toml++ 3.3) may see it, because of two inputs the parser can't
// take: keys of very many parts, over which it recurses until the stack ends, and some characters beyond
// ASCII, for which its search for white space has undefined behaviour, wherever they stand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sluice {

struct ScannedToml {
  bool utf8 = true;     ///< with characters up to U+FFFFF, the planes beyond being of private use
  std::string problem;  ///< "found ..., expected ...", the first of bad UTF-8 and keys of very many parts
  uint32_t line = 1, column = 1;  ///< of the problem, from 1, in characters
  std::string shielded;           ///< text for the parser, when there is no problem
};

/// Looks for problems, and moves the characters from U+0080 to U+FFFF one to one into the last private plane,
/// U+10xxxx, where the parser takes them for what they are to TOML: characters of strings and comments. Lines
/// and columns stay.
ScannedToml scan_toml(std::string_view text);

/// Moves the characters back, for all text that comes from the parser.
std::string unshield(std::string_view text);

}  // namespace sluice
