#include "tests/support/table.hpp"

#include <stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

std::string inline_toml(const nlohmann::ordered_json& value) {
  if (!value.is_structured()) return value.dump();  // numbers and strings are written alike
  std::string text = value.is_array() ? "[" : "{";
  bool first = true;
  for (const auto& item : value.items()) {
    text += (first ? "" : ", ") + (value.is_array() ? "" : item.key() + " = ") + inline_toml(item.value());
    first = false;
  }
  return text + (value.is_array() ? "]" : "}");
}

}  // namespace

size_t Table::place(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::runtime_error("no column " + name + " in " + header);
  return static_cast<size_t>(found - names.begin());
}

const std::string& Table::text(size_t row, const std::string& name) const {
  return rows.at(row)[place(name)];
}

double Table::at(size_t row, const std::string& name) const {
  const std::string& cell = text(row, name);
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0') throw std::runtime_error("\"" + cell + "\" is not a number");
  return value;
}

std::vector<double> Table::column(const std::string& name) const {
  std::vector<double> values;
  for (size_t row = 0; row < size(); ++row) values.push_back(at(row, name));
  return values;
}

Table read_table(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  if (!text.ends_with('\n')) throw std::runtime_error(path.string() + " ends within a line");
  std::istringstream lines(text);
  Table table;
  std::getline(lines, table.header);
  table.names = split(table.header);
  for (std::string line; std::getline(lines, line);) {
    table.rows.push_back(split(line));
    if (table.rows.back().size() != table.names.size())
      throw std::runtime_error(path.string() + ": a row does not fit the header: " + line);
  }
  return table;
}

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
  return nlohmann::ordered_json::parse(read_file(path));
}

std::string to_toml(const nlohmann::ordered_json& settings) {
  std::string text;
  for (const auto& [key, value] : settings.items()) text += key + " = " + inline_toml(value) + '\n';
  return text;
}

Image read_image(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* bytes = stbi_load(path.c_str(), &width, &height, &channels, 3);
  if (bytes == nullptr) throw std::runtime_error("can't read the picture " + path.string());
  Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
  image.rgb.assign(bytes, bytes + size_t{image.width} * image.height * 3);
  stbi_image_free(bytes);
  return image;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace sluice::test
