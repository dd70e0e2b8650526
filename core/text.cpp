// Formatting shared by files, pictures and the terminal.
#include "core/text.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace sluice {

std::string round_trip(double value, Precision precision) {
  if (std::isnan(value)) return "nan";  // a NaN's sign says nothing
  return precision == Precision::double_ ? fmt::format("{:.17g}", value) : fmt::format("{:.9g}", value);
}

std::string title_of(PressureMethod method) {
  std::string title(name_of(method));
  for (char& c : title) c = static_cast<char>(std::toupper(c));
  return title;
}

std::string bytes_text(double bytes) {
  for (const char* unit : {"B", "kB", "MB", "GB", "TB"}) {
    if (bytes < 1000) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= 1000;
  }
  return fmt::format("{:.3g} PB", bytes);
}

std::string duration_text(double seconds) {
  if (seconds < 1) return "under 1 s";
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds > 3.6e9) return "ages";
  const auto whole = static_cast<uint64_t>(seconds);
  if (seconds < 7200) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace sluice
