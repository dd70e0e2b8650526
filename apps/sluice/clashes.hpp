// Two outputs must not be one file or folder, and none may be what is read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sluice::app {

/// A file or folder and what it is to the user: "the scene", "--state". Devices and pipes may be named more
/// than once.
using NamedFile = std::pair<std::string, std::optional<std::filesystem::path>>;

/// Throws an InputError when a file is there twice.
void refuse_clashes(const std::vector<NamedFile>& files);

}  // namespace sluice::app
