// Who is cheapest at equal error.
#include <algorithm>
#include <limits>

#include "studies/pareto.hpp"

namespace sluice {

double least_error(const std::vector<Trade>& trades) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const Trade& trade : trades) {
    if (trade.error > 0 && !(trade.error >= least)) least = trade.error;
  }
  return least;
}

std::vector<Cheapest> cheapest_at(const std::vector<Trade>& trades, const std::vector<double>& targets) {
  std::vector<Cheapest> all;
  for (const double target : targets) {
    Cheapest cheapest{target, {}};
    for (const Trade& trade : trades) {
      if (!(trade.error <= cheapest.target)) continue;
      const auto same = std::ranges::find(cheapest.by_family, trade.family, &Trade::family);
      if (same == cheapest.by_family.end())
        cheapest.by_family.push_back(trade);
      else if (trade.seconds < same->seconds)
        *same = trade;
    }
    std::ranges::sort(cheapest.by_family, {}, &Trade::seconds);
    all.push_back(std::move(cheapest));
  }
  return all;
}

}  // namespace sluice
