// What TOML text needs before the parser (toml++ 3.3) may see it, because of two inputs the parser can't
// take: keys of very many parts, over which it recurses until the stack ends, and some characters beyond
// ASCII, for which its search for white space has undefined behaviour, wherever they stand.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sluice {

struct ScanProblem {
  uint32_t line = 1, column = 1;  ///< from 1, in characters
  std::string message;            ///< "found ..., expected ..."
};

/// Looks for text that isn't UTF-8 and for keys of very many parts. Nothing when the text is good in both.
std::optional<ScanProblem> scan_toml(std::string_view text);

/// Whether the text is UTF-8, with characters up to U+FFFFF, the planes beyond being of private use.
bool is_utf8(std::string_view text);

/// Moves the characters from U+0080 to U+FFFF of good UTF-8 one to one into the last private plane, U+10xxxx,
/// where the parser takes them for what they are to TOML: characters of strings and comments. Lines and
/// columns stay.
std::string shield(std::string_view text);

/// Moves them back, for all text that comes from the parser.
std::string unshield(std::string_view text);

}  // namespace sluice
