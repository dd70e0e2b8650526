// What a recording begins with; known to builds without recordings too.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "media/recording.hpp"
#include "media/recording_format.hpp"

namespace sluice {

bool is_recording(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(recording::magic.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return !start.empty() && recording::magic.starts_with(start);
}

void refuse_recording(const std::filesystem::path& path) {
  if (!is_recording(path)) return;
  throw InputError(fmt::format(
      "{}: found a recording, expected a scene; use `sluice play` or `sluice export` for it", path.string()));
}

}  // namespace sluice
