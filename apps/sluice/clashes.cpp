// Files by what they are on the disk.
#include "apps/sluice/clashes.hpp"

#include <fmt/format.h>

#include <map>

#include "sluice/error.hpp"

namespace sluice::app {

void refuse_clashes(const std::vector<NamedFile>& files) {
  std::map<std::filesystem::path, std::string> taken;
  for (const auto& [what, path] : files) {
    std::error_code error;
    if (!path) continue;
    const std::filesystem::file_status status = std::filesystem::status(*path, error);
    if (exists(status) && !is_regular_file(status) && !is_directory(status)) continue;  // /dev/stdout
    auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(*path), error);
    if (!place.has_filename()) place = place.parent_path();  // a folder may be named with a slash at its end
    const auto [other, fresh] = taken.try_emplace(place, what);
    if (fresh) continue;
    throw InputError(fmt::format("{}: found {}, which is {} too, expected a place of its own", what,
                                 path->string(), other->second));
  }
}

}  // namespace sluice::app
