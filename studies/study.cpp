// Points as words, and what they left.
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>

#include "media/recording.hpp"
#include "sluice/error.hpp"

namespace sluice::study {
namespace {

/// In quotes where a shell would read it as something else.
std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+,./:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text += '\'';
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& found) {
  throw InputError(fmt::format("{}: found {}; run this point again", file.string(), found));
}

nlohmann::json read_summary(const std::filesystem::path& path) {
  std::ifstream file(path);
  nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("format") || summary["format"] != 1)
    refuse(path, "no summary of a run");
  return summary;
}

/// The time at which the run of a point ends.
double planned_end(const Result& result) {
  const std::vector<std::string>& words = result.point.words;
  const auto word = std::ranges::find(words, "--time");
  return word != words.end() ? std::stod(*(word + 1)) : result.number("settings/time/duration");
}

/// Whether an override is what was run, as far as it is a plain number.
bool agrees(const Result& result, const std::string& text) {
  const size_t equals = text.find('=');
  std::string key = text.substr(0, equals);
  const char* value = text.c_str() + equals + 1;
  char* end = nullptr;
  const double wanted = std::strtod(value, &end);
  std::ranges::replace(key, '.', '/');
  const nlohmann::json::json_pointer place(fmt::format("/settings/{}", key));
  if (*end != '\0' || end == value || !result.summary.contains(place)) return true;
  const nlohmann::json& found = result.summary.at(place);
  return !found.is_number() || found.get<double>() == wanted;
}

/// InputError where the files are not those of a whole run of the point.
void check(const Result& result) {
  const PointFiles& files = result.files;
  if (!result.summary.contains("valid") || !result.summary["valid"].is_boolean())
    refuse(files.summary, "no word on whether the run is valid");
  std::map<std::string, std::string> overrides;  // the last of a key counts
  for (const std::string& text : result.point.overrides) overrides[text.substr(0, text.find('='))] = text;
  for (const auto& [key, text] : overrides) {
    if (!agrees(result, text)) refuse(files.summary, fmt::format("a run without {}", text));
  }
  if (result.valid() && result.number("time") < 0.99 * planned_end(result))
    refuse(files.summary, fmt::format("a run that was interrupted at time {:g}", result.number("time")));
  if (result.point.series && read_csv(files.series).size() == 0) refuse(files.series, "no step");
  if (result.point.recording) media::Recording recording(files.recording);  // checks every byte
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
  if (point.recording) words.insert(words.end(), {"--record", files.recording.string()});
  return words;
}

std::string line_of(const Point& point, const std::filesystem::path& folder) {
  std::string line = "sluice";
  for (const std::string& word : words_of(point, folder)) line += fmt::format(" {}", quoted(word));
  return line;
}

double Result::number(const std::string& key) const {
  const nlohmann::json::json_pointer place(fmt::format("/{}", key));
  if (!summary.contains(place) || !(summary.at(place).is_number() || summary.at(place).is_null()))
    refuse(files.summary, fmt::format("no number {}", key));
  const nlohmann::json& value = summary.at(place);
  return value.is_null() ? unknown_number : value.get<double>();
}

Results results_in(const std::filesystem::path& folder, const std::vector<Point>& points) {
  Results results;
  for (const Point& point : points) {
    PointFiles files(folder, point);
    std::error_code error;
    if (!std::filesystem::exists(files.summary, error)) continue;
    try {
      nlohmann::json summary = read_summary(files.summary);
      Result result{point, std::move(files), std::move(summary)};
      check(result);
      results.whole.push_back(std::move(result));
    } catch (const InputError& unusable) {
      results.unusable.push_back(unusable.what());
    }
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

}  // namespace sluice::study
