// Two tables of errors.
#include "studies/validation_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/validation.hpp"

namespace sluice::study {
namespace {

std::string percent(double error) {
  if (std::isinf(error)) return "invalid";
  return std::isnan(error) ? "" : fmt::format("{:.3g} %", 100 * error);
}

std::string order_text(const ErrorCurve& curve) {
  return std::isnan(curve.order()) ? "" : fmt::format("{:.1f}", curve.order());
}

std::string verdict(double error, double limit) {
  if (limit == 0) return "";
  if (std::isnan(error)) return "not run";
  return error <= limit ? "pass" : "FAIL";
}

struct Best {
  std::string method;
  ErrorCurve curve;
};

/// The method whose error in double is least at N = 40, or at N = 20 where none was run at N = 40.
Best best_of(const ErrorCurves& curves, const std::string& name, const std::string& quantity) {
  for (const int n : {40, 20}) {
    Best best;
    for (const auto& [key, curve] : curves) {
      if (key.name != name || key.quantity != quantity || key.machine != "double" || std::isnan(curve.at(n)))
        continue;
      if (best.method.empty() || curve.at(n) < best.curve.at(n)) best = {key.method, curve};
    }
    if (!best.method.empty()) return best;
  }
  return {};
}

void add_fault(std::vector<std::string>& faults, const ErrorKey& key, double error, double limit) {
  if (!(error > limit)) return;
  faults.push_back(fmt::format("{}: {} of {} is off by {} at N = 40, expected at most {}", key.name,
                               key.quantity, key.method, percent(error), percent(limit)));
}

/// Of the method that is best, or in exact cases of all.
void judge(const ErrorCurves& curves, const ValidationCase& known, const Limit& limit, const Best& best,
           std::vector<std::string>& faults) {
  if (!known.exact)
    add_fault(faults, {known.name, limit.quantity, best.method, ""}, best.curve.at(40), limit.at_40);
  for (const auto& [key, curve] : curves) {
    if (known.exact && key.name == known.name && key.quantity == limit.quantity && key.machine == "double")
      add_fault(faults, key, curve.at(40), limit.at_40);
  }
}

/// The best method of each quantity that has a limit, and whether it keeps it.
TextTable limits_table(const ErrorCurves& curves, std::vector<std::string>& faults) {
  TextTable table{{"case", "quantity", "best method", "N = 20", "N = 40", "N = 80", "order", "limit at 40",
                   "kept", "aim at 80", "met"},
                  {}};
  for (const ValidationCase& known : validation_cases()) {
    for (const Limit& limit : known.limits) {
      const Best best = best_of(curves, known.name, limit.quantity);
      const ErrorCurve& curve = best.curve;
      table.rows.push_back(
          {known.name, limit.quantity, best.method, percent(curve.at(20)), percent(curve.at(40)),
           percent(curve.at(80)), order_text(curve), percent(limit.at_40), verdict(curve.at(40), limit.at_40),
           limit.at_finest == 0 ? "" : percent(limit.at_finest), verdict(curve.at(80), limit.at_finest)});
      judge(curves, known, limit, best, faults);
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
    return other == curves.end() ? unknown_number : std::abs(other->second.at(n) - curve.at(n));
  };
  for (const int n : resolutions) row.push_back(percent(difference("float", n)));
  row.push_back(percent(difference("gpu", resolutions[0])));
  return row;
}

/// All methods; what rounding changes, as the difference of errors in float and on the GPU from those in
/// double.
TextTable methods_table(const ErrorCurves& curves) {
  TextTable table{
      {"case", "quantity", "method", "N = 20", "N = 40", "N = 80", "order", "float - double, N = 20",
       "float - double, N = 40", "float - double, N = 80", "gpu - double, N = 20"},
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
    if (other != curves.end() && std::isfinite(other->second.at(n)) && std::isfinite(curve.at(n)))
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
  return found == error.end() ? unknown_number : found->second;
}

double ErrorCurve::order() const {
  if (error.size() < 2 || !(error.begin()->second > 0) || !(error.rbegin()->second > 0) ||
      std::isinf(error.begin()->second) || std::isinf(error.rbegin()->second))
    return unknown_number;
  return std::log(error.begin()->second / error.rbegin()->second) /
         std::log(static_cast<double>(error.rbegin()->first) / error.begin()->first);
}

ValidationTables validation_tables(const ErrorCurves& curves, std::vector<std::string>& faults) {
  return {limits_table(curves, faults), methods_table(curves), rounding_words(curves)};
}

std::string page_of(const ValidationTables& tables) {
  return fmt::format("{}\n{}\n{}", tables.limits.markdown(), tables.methods.markdown(), tables.rounding);
}

}  // namespace sluice::study
