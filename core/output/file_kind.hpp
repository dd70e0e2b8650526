// What kinds of files of its own the program writes; known to builds that can't read them, too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sluice {

/// What a file says that it is.
struct FileKind {
  std::string_view magic;    ///< its first bytes
  uint32_t format;           ///< the number behind them
  std::string_view name;     ///< "recording"
  std::string_view made_by;  ///< the command that writes it
  std::string_view advice;   ///< what to do about one that is damaged
};

/// Whether the file begins as one of this kind does, however short it was cut.
bool begins_as(const FileKind& kind, const std::filesystem::path& path);

}  // namespace sluice
