// Drops without walls: an oscillating one and one that is drawn out.
#include "studies/validation_drops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sluice {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
using Words = std::vector<std::string>;

}  // namespace

std::vector<Measure> oscillation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs) {
  const double period = drop.period(), two_periods = 2 * period;
  std::vector<double> times, lead, energy;
  double axes = 0;
  for (const Blob& blob : blobs) {
    times.push_back(blob.time);
    lead.push_back(blob.semi_axes.x - blob.semi_axes.y);
    energy.push_back(blob.kinetic + drop.omega_squared * blob.distance_squared / 2);
    if (blob.time > two_periods) continue;
    const IdealDrop::State exact = drop.at(blob.time);
    axes = std::max({axes, std::abs(blob.semi_axes.x - exact.a), std::abs(blob.semi_axes.y - exact.b)});
  }
  // Not of the start, which is round but for rounding.
  double found = unknown;
  for (size_t i = 1, changes = 0; i + 1 < lead.size() && changes < 4; ++i) {
    if ((lead[i] < 0) != (lead[i + 1] < 0) && ++changes == 4) found = zero_after(i, times, lead) / 2;
  }
  const double lost = (energy.front() - value_at(two_periods, times, energy)) / 2 / blobs.front().kinetic;
  return {{"semi-axes", unknown, unknown, axes / drop.radius},
          {"period", found, period, std::abs(found / period - 1)},
          {"energy per period", lost, 0, std::abs(lost)}};
}

std::vector<Measure> elongation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs) {
  Measure major{"major semi-axis"}, minor{"minor semi-axis"};
  const auto take = [](Measure& measure, double ours, double reference) {
    const double error = std::abs(ours / reference - 1);
    if (error >= measure.error) measure = {measure.quantity, ours, reference, error};
  };
  for (const Blob& blob : blobs) {
    const IdealDrop::State exact = drop.at(blob.time);
    take(exact.a > exact.b ? major : minor, blob.semi_axes.x, exact.a);
    take(exact.a > exact.b ? minor : major, blob.semi_axes.y, exact.b);
  }
  return {major, minor};
}

std::vector<ValidationCase> drop_cases() { return {}; }

}  // namespace sluice
