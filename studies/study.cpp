// Points as words, and what they left.
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "core/error.hpp"

namespace sluice {
namespace {

/// In quotes where a shell would read it as something else.
std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+,./:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text += '\'';
}

nlohmann::json read_summary(const std::filesystem::path& path) {
  std::ifstream file(path);
  nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || summary.value("format", 0) != 1)
    throw InputError(fmt::format("{}: found no summary of a run; delete the file and run this point again",
                                 path.string()));
  return summary;
}

}  // namespace

const std::string& Point::fact(const std::string& column) const {
  const auto found = std::ranges::find(facts, column, &std::pair<std::string, std::string>::first);
  if (found == facts.end()) throw std::logic_error(fmt::format("{} has no fact {}", name, column));
  return found->second;
}

PointFiles::PointFiles(const std::filesystem::path& folder, const Point& point) {
  const auto file = [&](const char* ending) {
    return folder / "runs" / fmt::format("{}.{}", point.name, ending);
  };
  summary = file("json");
  series = file("csv");
  state = file("state.csv");
  recording = file("rec");
}

std::vector<std::string> words_of(const Point& point, const std::filesystem::path& folder) {
  const PointFiles files(folder, point);
  std::vector<std::string> words{"run",           point.scene, "--backend", point.backend, "--precision",
                                 point.precision, "--threads", "1",         "--quiet"};
  for (const std::string& text : point.overrides) words.insert(words.end(), {"--set", text});
  words.insert(words.end(), point.words.begin(), point.words.end());
  words.insert(words.end(), {"--summary", files.summary.string()});
  if (point.series) words.insert(words.end(), {"--series", files.series.string()});
  if (point.state) words.insert(words.end(), {"--state", files.state.string()});
  if (point.recording) words.insert(words.end(), {"--record", files.recording.string()});
  return words;
}

std::string line_of(const Point& point, const std::filesystem::path& folder) {
  std::string line = "sluice";
  for (const std::string& word : words_of(point, folder)) line += fmt::format(" {}", quoted(word));
  return line;
}

double Result::number(const std::string& key) const {
  const nlohmann::json& value = summary.at(nlohmann::json::json_pointer(fmt::format("/{}", key)));
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<Result> results_in(const std::filesystem::path& folder, const std::vector<Point>& points) {
  std::vector<Result> results;
  for (const Point& point : points) {
    PointFiles files(folder, point);
    std::error_code error;
    if (!std::filesystem::exists(files.summary, error)) continue;
    nlohmann::json summary = read_summary(files.summary);
    results.push_back({point, std::move(files), std::move(summary)});
  }
  return results;
}

TextTable tidy(const std::vector<Result>& results, const std::vector<std::string>& columns,
               const std::function<std::vector<std::string>(const Result&)>& measure) {
  TextTable table;
  for (const Result& result : results) {
    std::vector<std::string> names, cells;
    for (const auto& [name, cell] : result.point.facts) {
      names.push_back(name);
      cells.push_back(cell);
    }
    names.insert(names.end(), columns.begin(), columns.end());
    if (table.columns.empty()) table.columns = names;
    if (names != table.columns) throw std::logic_error(fmt::format("{} has other facts", result.point.name));
    const std::vector<std::string> measured = measure(result);
    cells.insert(cells.end(), measured.begin(), measured.end());
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string digits(double value, int count) {
  return std::isnan(value) ? "" : fmt::format("{:.{}g}", value, count);
}

}  // namespace sluice
