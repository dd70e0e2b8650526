// How recordings begin; known to builds without them too.
#include <fmt/format.h>

#include "media/recording.hpp"
#include "media/recording_format.hpp"
#include "sluice/error.hpp"

namespace sluice::media {

bool is_recording(const std::filesystem::path& path) { return begins_as(recording_file_kind, path); }

void refuse_recording(const std::filesystem::path& path) {
  if (!is_recording(path)) return;
  throw InputError(fmt::format(
      "{}: found a recording, expected a scene; use `sluice play` or `sluice export` for it", path.string()));
}

}  // namespace sluice::media
