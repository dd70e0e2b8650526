// Points of all cases, and their errors.
#include "studies/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "studies/validation_page.hpp"

namespace sluice::study {
namespace {

struct Machine {
  const char *name, *backend, *precision;
};
constexpr Machine machines[] = {
    {"double", "cpu", "double"}, {"float", "cpu", "float"}, {"gpu", "gpu", "float"}};

Point point_of(const ValidationCase& known, const Variant& variant, int n, const Machine& machine) {
  Point point{.name = fmt::format("{}_{}_{}_{}", known.name, variant.name, n, machine.name),
              .scene = fmt::format("validation/{}", known.name)};
  point.overrides = {fmt::format("particles.spacing={:.17g}", known.length / n)};
  for (const std::string& text : variant.overrides(n)) point.overrides.push_back(text);
  point.words = known.words;
  point.backend = machine.backend;
  point.precision = machine.precision;
  point.series = known.series;
  point.recording = known.recording;
  point.quick = n == resolutions[0];
  point.facts = {
      {"case", known.name}, {"method", variant.label}, {"n", std::to_string(n)}, {"machine", machine.name}};
  return point;
}

const ValidationCase& case_of(const Point& point) {
  const auto& cases = validation_cases();
  const auto found = std::ranges::find(cases, point.fact("case"), &ValidationCase::name);
  if (found == cases.end()) throw std::logic_error("a point of no case");
  return *found;
}

/// Of a run that became invalid, those that have a limit, infinitely far off.
std::vector<Measure> measures_of(const ValidationCase& known, const Result& result) {
  if (result.valid()) return known.measure(result);
  std::vector<Measure> measures;
  for (const Limit& limit : known.limits)
    measures.push_back({limit.quantity, unknown_number, unknown_number, invalid_error});
  return measures;
}

}  // namespace

const std::vector<ValidationCase>& validation_cases() {
  static const std::vector<ValidationCase> all = [] {
    std::vector<ValidationCase> cases = drop_cases();
    std::ranges::move(water_cases(), std::back_inserter(cases));
    return cases;
  }();
  return all;
}

std::vector<Point> validation_points() {
  std::vector<Point> points;
  for (const ValidationCase& known : validation_cases()) {
    for (const Variant& variant : known.variants) {
      for (const int n : resolutions) {
        for (const Machine& machine : machines) {
          // A software OpenGL is there to agree, not to be fast.
          if (std::string(machine.backend) == "gpu" && n > resolutions[0]) continue;
          points.push_back(point_of(known, variant, n, machine));
        }
      }
    }
  }
  return points;
}

Report validation_report(const std::vector<Result>& results) {
  TextTable tidy_rows{{"case", "method", "n", "machine", "quantity", "ours", "reference", "error", "seconds"},
                      {}};
  ErrorCurves curves;
  for (const Result& result : results) {
    const Point& point = result.point;
    const std::string seconds = digits(result.number("seconds/total"), 4);
    std::vector<std::string> row{point.fact("case"), point.fact("method"), point.fact("n"),
                                 point.fact("machine")};
    if (!result.valid()) {
      row.insert(row.end(), {"valid", "0", "1", "", seconds});
      tidy_rows.rows.push_back(row);
    }
    for (const Measure& measure : measures_of(case_of(point), result)) {
      std::vector<std::string> cells = row;
      cells.insert(cells.end(), {measure.quantity, digits(measure.ours), digits(measure.reference),
                                 digits(measure.error), seconds});
      tidy_rows.rows.push_back(std::move(cells));
      curves[{point.fact("case"), measure.quantity, point.fact("method"), point.fact("machine")}]
          .error[std::stoi(point.fact("n"))] = std::isnan(measure.error) ? invalid_error : measure.error;
    }
  }
  Report report;
  const ValidationTables tables = validation_tables(curves, report.faults);
  report.tables = {
      {"validate", tidy_rows}, {"validate_limits", tables.limits}, {"validate_methods", tables.methods}};
  report.page = page_of(tables);
  return report;
}

}  // namespace sluice::study
