// Who is cheapest at equal error.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "studies/pareto.hpp"

namespace sluice::study {

double least_error(const std::vector<Trade>& trades) {
  double least = unknown_number;
  for (const Trade& trade : trades) {
    if (trade.error > 0 && !(trade.error >= least)) least = trade.error;
  }
  return least;
}

std::vector<double> errors_of_curves(const std::vector<Trade>& trades, const std::string& family) {
  std::map<std::string, double> largest;
  for (const Trade& trade : trades) {
    if (trade.family != family) continue;
    double& error = largest.emplace(trade.curve, 0.0).first->second;
    error = std::max(error, trade.error);
  }
  std::vector<double> errors;
  for (const auto& [curve, error] : largest) errors.push_back(1.05 * error);
  std::ranges::sort(errors, std::greater<>());
  return errors;
}

std::vector<Cheapest> cheapest_at(const std::vector<Trade>& trades, const std::vector<double>& targets) {
  std::vector<Cheapest> all;
  for (const double target : targets) {
    Cheapest cheapest{target, {}, {}};
    for (const Trade& trade : trades) {
      if (!(trade.error <= cheapest.target)) continue;
      const auto same = std::ranges::find(cheapest.by_family, trade.family, &Trade::family);
      if (same == cheapest.by_family.end())
        cheapest.by_family.push_back(trade);
      else if (trade.seconds < same->seconds)
        *same = trade;
    }
    std::ranges::sort(cheapest.by_family, {}, &Trade::seconds);
    for (const Trade& trade : trades) {
      if (std::ranges::find(cheapest.by_family, trade.family, &Trade::family) == cheapest.by_family.end() &&
          std::ranges::find(cheapest.never, trade.family) == cheapest.never.end())
        cheapest.never.push_back(trade.family);
    }
    all.push_back(std::move(cheapest));
  }
  return all;
}

std::string words_for(const Cheapest& cheapest) {
  if (cheapest.by_family.empty()) return "nobody";
  std::string words = fmt::format("{}: {:.3g} s", cheapest.by_family[0].label, cheapest.by_family[0].seconds);
  for (size_t i = 1; i < cheapest.by_family.size(); ++i) {
    const Trade& trade = cheapest.by_family[i];
    words +=
        fmt::format("; {} {:.1f} times as long", trade.family, trade.seconds / cheapest.by_family[0].seconds);
  }
  for (const std::string& family : cheapest.never) words += fmt::format("; {} not at all", family);
  return words;
}

}  // namespace sluice::study
