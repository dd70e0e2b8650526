// What recordings and checkpoints begin with; known to builds without them too.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "media/checkpoint.hpp"
#include "media/checkpoint_format.hpp"
#include "media/recording.hpp"
#include "media/recording_format.hpp"

namespace sluice {
namespace {

/// Whether the file begins like this, however short it was cut.
bool begins_with(const std::filesystem::path& path, std::string_view magic) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(magic.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return !start.empty() && magic.starts_with(start);
}

}  // namespace

bool is_recording(const std::filesystem::path& path) { return begins_with(path, recording::magic); }

void refuse_recording(const std::filesystem::path& path) {
  if (!is_recording(path)) return;
  throw InputError(fmt::format(
      "{}: found a recording, expected a scene; use `sluice play` or `sluice export` for it", path.string()));
}

void refuse_checkpoint(const std::filesystem::path& path) {
  if (!begins_with(path, checkpoint::magic)) return;
  throw InputError(fmt::format("{}: found a checkpoint, expected a scene; use `sluice run --resume {}`",
                               path.string(), path.string()));
}

}  // namespace sluice
