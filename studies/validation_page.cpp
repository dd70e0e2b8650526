// Two tables of errors.
#include "studies/validation_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "studies/validation.hpp"

namespace sluice {
namespace {

constexpr double unknown_error = std::numeric_limits<double>::quiet_NaN();

std::string percent(double error) { return std::isnan(error) ? "" : fmt::format("{:.3g} %", 100 * error); }

std::string order_text(const ErrorCurve& curve) {
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
  ErrorCurve curve;
};

Best best_of(const ErrorCurves& curves, const std::string& name, const std::string& quantity) {
  Best best;
  for (const auto& [key, curve] : curves) {
    if (key.name != name || key.quantity != quantity || key.machine != "double") continue;
    const double error = curve.decisive();
    if (best.method.empty() || error < best.curve.decisive()) best = {key.method, curve};
  }
  return best;
}

/// The best method of each quantity that has a limit, and whether it keeps it.
TextTable limits_table(const ErrorCurves& curves, std::vector<std::string>& faults) {
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

std::vector<std::string> method_row(const ErrorCurves& curves, const ErrorKey& key, const ErrorCurve& curve) {
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
TextTable methods_table(const ErrorCurves& curves) {
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

/// By how much of itself the error of each row changes from double to `machine`, in order. Errors that are
/// rounding themselves are left out.
std::vector<double> changes(const ErrorCurves& curves, const std::string& machine, int n) {
  constexpr double rounding = 1e-9;
  std::vector<double> all;
  for (const auto& [key, curve] : curves) {
    if (key.machine != "double" || !(curve.at(n) > rounding)) continue;
    const auto other = curves.find({key.name, key.quantity, key.method, machine});
    if (other != curves.end() && !std::isnan(other->second.at(n)))
      all.push_back(std::abs(other->second.at(n) / curve.at(n) - 1));
  }
  std::ranges::sort(all);
  return all;
}

/// The value that this part of them does not exceed.
double quantile(const std::vector<double>& sorted, double part) {
  return sorted[std::min(sorted.size() - 1, static_cast<size_t>(part * static_cast<double>(sorted.size())))];
}

std::string rounding_words(const ErrorCurves& curves) {
  std::string words;
  for (const auto& [machine, title] : {std::pair{"float", "in float"}, {"gpu", "on the GPU"}}) {
    for (const int n : resolutions) {
      const std::vector<double> all = changes(curves, machine, n);
      if (all.empty()) continue;
      words += fmt::format(
          "- N = {}, {} instead of double: half of {} errors change by less than {} of themselves, "
          "nine of ten by less than {}\n",
          n, title, all.size(), percent(quantile(all, 0.5)), percent(quantile(all, 0.9)));
    }
  }
  return words;
}

}  // namespace

double ErrorCurve::at(int n) const {
  const auto found = error.find(n);
  return found == error.end() ? unknown_error : found->second;
}

double ErrorCurve::decisive() const { return std::isnan(at(40)) ? at(20) : at(40); }

double ErrorCurve::order() const {
  if (error.size() < 2 || !(error.begin()->second > 0) || !(error.rbegin()->second > 0)) return unknown_error;
  return std::log(error.begin()->second / error.rbegin()->second) /
         std::log(static_cast<double>(error.rbegin()->first) / error.begin()->first);
}

std::string validation_page(const ErrorCurves& curves, std::vector<std::string>& faults) {
  return fmt::format("{}\n{}\n{}", limits_table(curves, faults).markdown(), methods_table(curves).markdown(),
                     rounding_words(curves));
}

}  // namespace sluice
