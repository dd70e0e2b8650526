// Markdown, three digits at a time.
#include "bench/tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/stopwatch.hpp"

namespace sluice::bench {

std::string number_text(double value) {
  if (std::isnan(value)) return "-";
  return fmt::format("{:.{}f}", value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

std::string others_text(std::optional<double> others) {
  if (!others) return "- other programs meanwhile: not known\n";
  return fmt::format("- other programs meanwhile: {:.2f} processors{}\n", *others,
                     was_busy(others)
                         ? "; **the machine was busy: these figures are not to be compared with others'**"
                         : "");
}

std::string table_row(const std::string& title, const std::vector<std::string>& cells) {
  return fmt::format("| {} | {} |\n", title, fmt::join(cells, " | "));
}

std::string table_head(const std::string& title, const std::vector<std::string>& names) {
  return table_row(title, names) + table_row("---", std::vector<std::string>(names.size(), "---:"));
}

}  // namespace sluice::bench
