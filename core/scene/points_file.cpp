// A reader of CSV without quotes.
#include "core/scene/points_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

#include "sluice/error.hpp"

namespace sluice {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> cells;
  for (size_t from = 0; from <= line.size();) {
    const size_t to = std::min(line.find(',', from), line.size());
    std::string_view cell = line.substr(from, to - from);
    while (cell.starts_with(' ')) cell.remove_prefix(1);
    while (cell.ends_with(' ')) cell.remove_suffix(1);
    cells.push_back(cell);
    from = to + 1;
  }
  return cells;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

Points read_points(const std::filesystem::path& path) {
  std::error_code error;
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, error)) file.open(path);
  std::string line;
  if (!std::getline(file, line)) throw InputError(fmt::format("{}, which can't be read", path.string()));
  if (line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
  const std::string first_line = line;
  const auto header = cells_of(first_line);
  const auto column = [&](std::string_view name) {
    return static_cast<size_t>(std::ranges::find(header, name) - header.begin());
  };
  std::array<size_t, 4> places{column("x"), column("y"), column("vx"), column("vy")};
  const size_t columns = header.size();
  if (places[0] == columns || places[1] == columns)
    throw InputError(fmt::format("{}, whose first line does not name the columns x and y", path.string()));
  Points points;
  for (size_t number = 2; std::getline(file, line); ++number) {
    if (line.empty() || line == "\r") continue;
    const auto cells = cells_of(line);
    std::array<double, 4> values{};
    for (size_t k = 0; k < 4; ++k) {
      if (places[k] == columns) continue;
      const auto value = places[k] < cells.size() ? number_of(cells[places[k]]) : std::nullopt;
      if (!value)
        throw InputError(
            fmt::format("{}:{}, which has no finite number {}", path.string(), number, header[places[k]]));
      values[k] = *value;
    }
    points.at.emplace_back(values[0], values[1]);
    points.velocity.emplace_back(values[2], values[3]);
  }
  return points;
}

}  // namespace sluice
