// Particles from a CSV file.
#pragma once

#include <filesystem>

#include "sluice/scene.hpp"

namespace sluice {

/// The columns x and y, and vx and vy if there are these, of a file with a header and a row per particle;
/// other columns are passed over. InputError, with the file and the line, for anything else.
Points read_points(const std::filesystem::path& path);

}  // namespace sluice
