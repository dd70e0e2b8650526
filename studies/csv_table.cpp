// Lines -> cells.
#include "studies/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "sluice/error.hpp"

namespace sluice::study {
namespace {

/// A quote in quotes is written twice, so that of each pair the second begins the text again.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (!quoted && i > 0 && line[i - 1] == '"') cells.back() += '"';
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text)
    throw InputError(
        fmt::format("{}: found a file that can't be read, expected a table as CSV", path.string()));
  return std::move(text).str();
}

}  // namespace

size_t CsvTable::place(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw InputError(
        fmt::format("{}: found no column {}, expected one in its header {}", file.string(), name, header));
  return static_cast<size_t>(found - names.begin());
}

const std::string& CsvTable::text(size_t row, const std::string& name) const {
  return rows.at(row)[place(name)];
}

double CsvTable::at(size_t row, const std::string& name) const {
  const std::string& cell = text(row, name);
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0')
    throw InputError(
        fmt::format("{}: row {}: {}: found \"{}\", expected a number", file.string(), row + 1, name, cell));
  return value;
}

std::vector<double> CsvTable::column(const std::string& name) const {
  std::vector<double> values;
  values.reserve(size());
  for (size_t row = 0; row < size(); ++row) values.push_back(at(row, name));
  return values;
}

CsvTable read_csv(const std::filesystem::path& path) {
  const std::string text = text_of_file(path);
  if (!text.ends_with('\n'))
    throw InputError(fmt::format("{}: found an end within a line, expected a whole table", path.string()));
  std::istringstream lines(text);
  CsvTable table;
  table.file = path;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells = split(line);
    if (table.names.empty()) {
      table.header = line;
      table.names = std::move(cells);
      continue;
    }
    if (cells.size() != table.names.size())
      throw InputError(
          fmt::format("{}: found the row {}, expected {} cells", path.string(), line, table.names.size()));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace sluice::study
