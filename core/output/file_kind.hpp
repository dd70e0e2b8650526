// What kinds of files of its own the program writes; known to builds that can't read them, too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sluice {

/// Kind of a file, as its first bytes tell it.
struct FileKind {
  std::string_view magic;    ///< first bytes of the file
  uint32_t format;           ///< number of the format, behind them
  std::string_view name;     ///< "recording"
  std::string_view made_by;  ///< the command that writes it
  std::string_view advice;   ///< what to do about one that is damaged
};

/// Whether the file begins as one of this kind does, however short it was cut.
bool begins_as(const FileKind& kind, const std::filesystem::path& path);

}  // namespace sluice
