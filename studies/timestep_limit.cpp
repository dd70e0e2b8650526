// What the grid of time steps says.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "studies/time_curve.hpp"
#include "studies/timestep.hpp"

namespace sluice::study {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : std::max(values[half - 1], values[half]);
}

}  // namespace

StepLimit step_limit(const std::vector<Trial>& trials) {
  std::map<double, std::vector<double>> by_dt, lost;
  std::map<int, double> by_start;
  for (const Trial& trial : trials) {
    by_dt[trial.dt].push_back(trial.cfl);
    lost[trial.dt].push_back(trial.lost);
    double& largest = by_start.emplace(trial.start, 0.0).first->second;
    if (trial.cfl <= 1) largest = std::max(largest, trial.dt);
  }
  StepLimit limit;
  bool steady = true;
  for (const auto& [dt, cfl] : by_dt) {
    const bool passes = median(cfl) <= 1;
    steady = steady && passes;
    if (passes) limit.dt = dt;
    if (steady) limit.steady = dt;
  }
  if (by_start.empty()) return limit;
  if (limit.dt > 0) {
    limit.lost = median(lost[limit.dt]);
    limit.starts = lost[limit.dt].size();
  }
  limit.least = std::numeric_limits<double>::infinity();
  for (const auto& [start, dt] : by_start) {
    limit.least = std::min(limit.least, dt);
    limit.most = std::max(limit.most, dt);
  }
  limit.at_the_end = limit.dt == by_dt.rbegin()->first;
  return limit;
}

double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  TimeCurve logarithms;
  for (size_t i = 0; i < x.size(); ++i) logarithms.add(std::log(x[i]), std::log(y[i]));
  return slope_of(logarithms);
}

}  // namespace sluice::study
