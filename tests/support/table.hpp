// Files the program writes, read back: CSV tables, summaries, pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "draw/image.hpp"
#include "studies/csv_table.hpp"

namespace sluice::test {

using namespace study;

using Table = CsvTable;

/// Throws when a row has more or fewer cells than the header, or when the last line is not ended.
inline Table read_table(const std::filesystem::path& path) { return read_csv(path); }

nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// A scene file with the `settings` of a summary: TOML, each table on one line, as in
/// fluid = {gravity = [0, -9.81]}.
std::string to_toml(const nlohmann::ordered_json& settings);

/// A picture file; throws when it is not one.
draw::Image read_image(const std::filesystem::path& path);

/// Names of all files and folders in a folder, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

}  // namespace sluice::test
