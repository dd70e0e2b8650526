// A study: points, each an ordinary `sluice run`, and the tables that are made of what they leave.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/csv_table.hpp"
#include "studies/table.hpp"

namespace sluice::study {

/// A run of a study.
struct Point {
  std::string name;   ///< unique in the study; of its files
  std::string scene;  ///< as `sluice run` takes it
  /// What is set of the scene, KEY=VALUE.
  std::vector<std::string> overrides = {};
  /// Further words, such as {"--time", "5"}.
  std::vector<std::string> words = {};
  std::string backend = "cpu", precision = "double";
  bool series = false, recording = false;  ///< files wanted beside the summary
  bool quick = false;                      ///< also part of `--quick`
  /// What the point is in the table: columns and their cells, the same columns for all points of a study.
  std::vector<std::pair<std::string, std::string>> facts = {};

  /// The cell of a fact that is there.
  const std::string& fact(const std::string& column) const;
};

/// Files of a point in the folder of its study.
struct PointFiles {
  PointFiles(const std::filesystem::path& folder, const Point& point);
  std::filesystem::path summary, series, recording;
};

/// What follows `sluice`: run SCENE --backend ... --summary FILE.
std::vector<std::string> words_of(const Point& point, const std::filesystem::path& folder);

/// The same as a line for a shell.
std::string line_of(const Point& point, const std::filesystem::path& folder);

/// What a point left.
struct Result {
  Point point;
  PointFiles files;
  nlohmann::json summary;

  bool valid() const { return summary.at("valid").get<bool>(); }
  /// A number of the summary; NaN where it is null. Parts are separated by '/', as in "seconds/total".
  /// InputError where there is none.
  double number(const std::string& key) const;
};

/// What is there of the points, in their order.
struct Results {
  std::vector<Result> whole;
  /// Of those that are there but no good, which file and why: not a summary, of a run that was interrupted or
  /// of another one, without its series or recording.
  std::vector<std::string> unusable;
};
Results results_in(const std::filesystem::path& folder, const std::vector<Point>& points);

/// What a study ends in.
struct Report {
  /// CSV tables by the name of their file, without its ending.
  std::vector<std::pair<std::string, TextTable>> tables;
  std::string page;                 ///< for people, as Markdown
  std::vector<std::string> faults;  ///< what is asserted and did not come out
};

struct Study {
  const char *name, *what;
  std::vector<Point> (*points)();
  Report (*report)(const std::vector<Result>& results);
};

/// All studies of this kind.
const std::vector<Study>& studies();

/// A table with the facts of each result, and further columns that `measure` fills.
TextTable tidy(const std::vector<Result>& results, const std::vector<std::string>& columns,
               const std::function<std::vector<std::string>(const Result&)>& measure);

inline constexpr double unknown_number = std::numeric_limits<double>::quiet_NaN();

/// A number with so many digits; empty for NaN.
std::string digits(double value, int count = 6);

}  // namespace sluice::study
