// Every point in a process of its own, as `sluice run` would run it; then the tables.
#include "apps/sluice/study_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "apps/sluice/children.hpp"
#include "apps/sluice/command_line.hpp"
#include "apps/sluice/commands.hpp"
#include "core/output/output_file.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

namespace fs = std::filesystem;

std::vector<Point> points_of(const Study& study, const StudyOptions& options) {
  std::vector<Point> points = study.points();
  std::erase_if(points, [&](const Point& point) {
    return point.name.find(options.only) == std::string::npos || (options.quick && !point.quick);
  });
  if (points.empty()) {
    throw InputError(
        fmt::format("--only: found \"{}\", expected text from the name of a {}point; --list prints them",
                    options.only, options.quick ? "quick " : ""));
  }
  return points;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw EnvironmentError(fmt::format("{}: the folder can't be created: {}; choose another for --out",
                                       folder.string(), error.message()));
  }
}

/// Runs the point in this process and returns its exit code.
int run_point(const Point& point, const fs::path& folder) {
  std::vector<std::string> words = words_of(point, folder);
  words.erase(words.begin());  // "run"
  return run_command(run_options_of(std::move(words)));
}

/// A result of an earlier run must not be taken for one of this.
void remove_files(const PointFiles& files) {
  std::error_code error;
  for (const fs::path& path : {files.summary, files.series, files.recording}) fs::remove(path, error);
}

/// Whether all points ran; those that became invalid did.
bool run_all(const std::vector<Point>& points, const fs::path& folder, int jobs) {
  make_folder(folder / "runs");
  for (const Point& point : points) remove_files(PointFiles(folder, point));
  const auto task = [&](size_t i) {
    // Why a run is invalid is in its summary.
    if (std::freopen("/dev/null", "w", stderr) == nullptr)
      throw EnvironmentError("/dev/null can't be opened");
    return std::to_string(run_point(points[i], folder));
  };
  size_t ended = 0;
  bool all = true;
  in_children(points.size(), jobs, task, [&](size_t i, const ChildEnd& end) {
    const bool ran = end.signal == 0 && end.code == 0 && (end.text == "0" || end.text == "1");
    std::string how = end.text == "0" ? "done" : "became invalid";
    if (end.signal != 0) how = fmt::format("crashed with signal {}", end.signal);
    if (end.signal == 0 && !ran) how = fmt::format("failed: {}", end.text);
    all = all && ran;
    fmt::print(stderr, "{:>5}/{} {:6.1f} s  {}: {}\n", ++ended, points.size(), end.seconds, points[i].name,
               how);
  });
  return all;
}

/// Makes the tables of those results that are there. Returns the exit code.
int collect(const Study& study, const std::vector<Point>& points, const fs::path& from, const fs::path& to) {
  const auto [results, unusable] = results_in(from, points);
  for (const std::string& what : unusable) fmt::print(stderr, "sluice: {}\n", what);
  if (results.empty()) {
    throw InputError(
        fmt::format("{}: found no result of the study {}, expected files runs/NAME.json; run the "
                    "lines of `sluice study {} --out {} --list` first",
                    from.string(), study.name, study.name, from.string()));
  }
  if (results.size() < points.size())
    fmt::print(stderr, "sluice: {} of {} results are not there; the tables are without them\n",
               points.size() - results.size(), points.size());
  const Report report = study.report(results);
  make_folder(to);
  for (const auto& [name, table] : report.tables) write_file(to / fmt::format("{}.csv", name), table.csv());
  write_file(to / fmt::format("{}.md", study.name), report.page);
  fmt::print("{}", report.page);
  for (const std::string& fault : report.faults) fmt::print(stderr, "sluice: not as expected: {}\n", fault);
  return report.faults.empty() && unusable.empty() ? 0 : 1;
}

}  // namespace

int study_points(const Study& study, const StudyOptions& options) {
  const std::vector<Point> points = points_of(study, options);
  if (options.list) {
    make_folder(*options.out / "runs");
    for (const Point& point : points) fmt::print("{}\n", line_of(point, *options.out));
    return 0;
  }
  if (options.collect)
    return collect(study, points, *options.collect, options.out.value_or(*options.collect));
  if (run_all(points, *options.out, options.jobs)) return collect(study, points, *options.out, *options.out);
  if (!results_in(*options.out, points).whole.empty()) collect(study, points, *options.out, *options.out);
  return 1;
}

}  // namespace sluice::app
