// Tables as text.
#include "studies/table.hpp"

#include <algorithm>

namespace sluice::study {
namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += c;
    text += c;
  }
  text += '"';
  return text;
}

/// A bar would end the cell, a line end the table.
std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) {
    if (c == '|') text += '\\';
    text += c == '\n' ? ' ' : c;
  }
  return text;
}

}  // namespace

size_t place_of(const std::string& column, const std::vector<std::string>& columns) {
  return static_cast<size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
}

std::string TextTable::csv() const {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      text += quoted(row[i]);
    }
    text += '\n';
  };
  add(columns);
  for (const auto& row : rows) add(row);
  return text;
}

std::string TextTable::markdown() const {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    text += '|';
    for (const std::string& cell : row) {
      text += ' ';
      text += escaped(cell);
      text += " |";
    }
    text += '\n';
  };
  add(columns);
  text += '|';
  for (size_t i = 0; i < columns.size(); ++i) text += "---|";
  text += '\n';
  for (const auto& row : rows) add(row);
  return text;
}

TextTable TextTable::only(const std::vector<std::string>& names) const {
  TextTable part{names, {}};
  for (const auto& row : rows) {
    auto& cells = part.rows.emplace_back();
    for (const std::string& name : names) cells.push_back(row.at(place_of(name, columns)));
  }
  return part;
}

}  // namespace sluice::study
