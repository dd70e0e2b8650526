// Numbers and rows of the Markdown tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sluice::bench {

/// Three digits or more; a dash for what was not measured (NaN).
std::string number_text(double value);

/// A line about what other programs did on the machine meanwhile, marked if it was much.
std::string others_text(std::optional<double> others);

/// "| title | cell | cell |" and the end of the line.
std::string table_row(const std::string& title, const std::vector<std::string>& cells);

/// The row of names, and the line below it.
std::string table_head(const std::string& title, const std::vector<std::string>& names);

}  // namespace sluice::bench
