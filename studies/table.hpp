// A table of text cells, as CSV and as Markdown: what every study ends in.
#pragma once

#include <string>
#include <vector>

namespace sluice {

struct TextTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// RFC 4180: cells with commas, quotes or line ends are quoted.
  std::string csv() const;
  std::string markdown() const;
  /// Only these columns, which are there, in this order.
  TextTable only(const std::vector<std::string>& names) const;
};

}  // namespace sluice
