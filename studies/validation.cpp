// Points of all cases, and errors, orders and verdicts.
#include "studies/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace sluice {
namespace {

constexpr int resolutions[] = {20, 40, 80};
constexpr double unknown_error = std::numeric_limits<double>::quiet_NaN();

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

/// Every quantity of a curve: errors by resolution.
struct Curve {
  std::map<int, double> error;

  double at(int n) const {
    const auto found = error.find(n);
    return found == error.end() ? unknown_error : found->second;
  }
  /// At N = 40, or where that was not run at N = 20.
  double decisive() const { return std::isnan(at(40)) ? at(20) : at(40); }
  /// The slope of the error over the spacing, from the coarsest to the finest.
  double order() const {
    if (error.size() < 2 || !(error.begin()->second > 0) || !(error.rbegin()->second > 0))
      return unknown_error;
    return std::log(error.begin()->second / error.rbegin()->second) /
           std::log(static_cast<double>(error.rbegin()->first) / error.begin()->first);
  }
};

struct Key {
  std::string name, quantity, method, machine;
  auto operator<=>(const Key&) const = default;
};

std::string percent(double error) { return std::isnan(error) ? "" : fmt::format("{:.3g} %", 100 * error); }

std::string order_text(const Curve& curve) {
  return std::isnan(curve.order()) ? "" : fmt::format("{:.1f}", curve.order());
}

std::string verdict(double error, double limit) {
  if (limit == 0) return "";
  if (std::isnan(error)) return "not run";
  return error <= limit ? "pass" : "FAIL";
}

/// Of these errors at N = 20, 40, 80 in double: the method that is best at N = 40.
struct Best {
  std::string method;
  Curve curve;
};

Best best_of(const std::map<Key, Curve>& curves, const std::string& name, const std::string& quantity) {
  Best best;
  for (const auto& [key, curve] : curves) {
    if (key.name != name || key.quantity != quantity || key.machine != "double") continue;
    const double error = curve.decisive();
    if (best.method.empty() || error < best.curve.decisive()) best = {key.method, curve};
  }
  return best;
}

/// The best method of each quantity that has a limit, and whether it keeps it.
TextTable limits_table(const std::map<Key, Curve>& curves, std::vector<std::string>& faults) {
  TextTable table{{"case", "quantity", "best method", "N = 20", "N = 40", "N = 80", "order", "limit at 40",
                   "", "aim at 80", ""},
                  {}};
  for (const ValidationCase& known : validation_cases()) {
    for (const Limit& limit : known.limits) {
      const auto [method, curve] = best_of(curves, known.name, limit.quantity);
      const double at_40 = curve.at(40), at_80 = curve.at(80);
      table.rows.push_back({known.name, limit.quantity, method, percent(curve.at(20)), percent(at_40),
                            percent(at_80), order_text(curve), percent(limit.at_40),
                            verdict(at_40, limit.at_40), limit.at_finest == 0 ? "" : percent(limit.at_finest),
                            verdict(at_80, limit.at_finest)});
      if (at_40 > limit.at_40)
        faults.push_back(fmt::format("{}: {} is off by {} at N = 40, expected at most {}", known.name,
                                     limit.quantity, percent(at_40), percent(limit.at_40)));
    }
  }
  return table;
}

std::vector<std::string> method_row(const std::map<Key, Curve>& curves, const Key& key, const Curve& curve) {
  std::vector<std::string> row{key.name, key.quantity, key.method};
  for (const int n : resolutions) row.push_back(percent(curve.at(n)));
  row.push_back(order_text(curve));
  const auto difference = [&](const char* machine, int n) {
    const auto other = curves.find({key.name, key.quantity, key.method, machine});
    return other == curves.end() ? unknown_error : std::abs(other->second.at(n) - curve.at(n));
  };
  for (const int n : resolutions) row.push_back(percent(difference("float", n)));
  row.push_back(percent(difference("gpu", resolutions[0])));
  return row;
}

/// All methods; what rounding changes, as the difference of errors in float and on the GPU from those in
/// double.
TextTable methods_table(const std::map<Key, Curve>& curves) {
  TextTable table{{"case", "quantity", "method", "N = 20", "N = 40", "N = 80", "order",
                   "float - double, N = 20", "N = 40", "N = 80", "gpu - double, N = 20"},
                  {}};
  for (const ValidationCase& known : validation_cases()) {
    for (const auto& [key, curve] : curves) {
      if (key.name == known.name && key.machine == "double")
        table.rows.push_back(method_row(curves, key, curve));
    }
  }
  return table;
}

std::string validation_page(const std::map<Key, Curve>& curves, std::vector<std::string>& faults) {
  return fmt::format("{}\n{}", limits_table(curves, faults).markdown(), methods_table(curves).markdown());
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
  std::map<Key, Curve> curves;
  for (const Result& result : results) {
    const Point& point = result.point;
    const std::string seconds = digits(result.number("seconds/total"), 4);
    std::vector<std::string> row{point.fact("case"), point.fact("method"), point.fact("n"),
                                 point.fact("machine")};
    if (!result.valid()) {
      row.insert(row.end(), {"valid", "0", "1", "", seconds});
      tidy_rows.rows.push_back(row);
      continue;
    }
    for (const Measure& measure : case_of(point).measure(result)) {
      std::vector<std::string> cells = row;
      cells.insert(cells.end(), {measure.quantity, digits(measure.ours), digits(measure.reference),
                                 digits(measure.error), seconds});
      tidy_rows.rows.push_back(std::move(cells));
      curves[{point.fact("case"), measure.quantity, point.fact("method"), point.fact("machine")}]
          .error[std::stoi(point.fact("n"))] = measure.error;
    }
  }
  Report report;
  report.tables = {{"validate", tidy_rows}};
  report.page = validation_page(curves, report.faults);
  return report;
}

}  // namespace sluice
