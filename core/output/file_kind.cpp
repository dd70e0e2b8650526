// The first bytes of a file, and checkpoints told by them.
#include "core/output/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "core/output/checkpoint.hpp"
#include "core/output/checkpoint_format.hpp"
#include "sluice/error.hpp"

namespace sluice {

bool begins_as(const FileKind& kind, const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(kind.magic.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return !start.empty() && kind.magic.starts_with(start);
}

void refuse_checkpoint(const std::filesystem::path& path) {
  if (!begins_as(checkpoint_file_kind, path)) return;
  throw InputError(fmt::format("{}: found a checkpoint, expected a scene; use `sluice run --resume {}`",
                               path.string(), path.string()));
}

}  // namespace sluice
