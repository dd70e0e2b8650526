// A table of text cells, as CSV and as Markdown: what every study ends in.
#pragma once

#include <string>
#include <vector>

namespace sluice::study {

/// The place of a column that is there.
size_t place_of(const std::string& column, const std::vector<std::string>& columns);

struct TextTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// RFC 4180: cells with commas, quotes or line ends are quoted.
  std::string csv() const;
  std::string markdown() const;
  /// Only these columns, which are there, in this order.
  TextTable only(const std::vector<std::string>& names) const;
};

}  // namespace sluice::study
