// Files the program writes, read back: CSV tables, summaries, pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/image.hpp"

namespace sluice::test {

/// A CSV file with a header, the cells as they are written.
struct Table {
  std::string header;
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  size_t size() const { return rows.size(); }
  const std::string& text(size_t row, const std::string& name) const;
  double at(size_t row, const std::string& name) const;
  std::vector<double> column(const std::string& name) const;

 private:
  size_t place(const std::string& name) const;
};

/// Throws when a row has more or fewer cells than the header, or when the last line is not ended.
Table read_table(const std::filesystem::path& path);

nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// A scene file with the `settings` of a summary: TOML, each table on one line, as in
/// fluid = {gravity = [0, -9.81]}.
std::string to_toml(const nlohmann::ordered_json& settings);

/// A picture file; throws when it is not one.
Image read_image(const std::filesystem::path& path);

/// Names of all files and folders in a folder, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

}  // namespace sluice::test
