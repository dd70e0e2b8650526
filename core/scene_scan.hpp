// A first look at TOML text, before the parser may see it.
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

/// Looks for what the parser (toml++ 3.3) can't refuse by itself: a key of very many parts, over which it
/// recurses until the stack ends, and characters beyond ASCII where it looks for white space, which it has
/// undefined behaviour for. Neither has a place in a scene. Nothing when the text may be parsed.
std::optional<ScanProblem> scan_toml(std::string_view text);

/// Whether the text is UTF-8 without overlong forms and surrogates.
bool is_utf8(std::string_view text);

}  // namespace sluice
