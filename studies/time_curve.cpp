// Distances of curves, delays, oscillations.
#include "studies/time_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/study.hpp"

namespace sluice::study {
namespace {

/// The top of the parabola through three points.
double top_of(const TimeCurve& curve, size_t i) {
  const double a = curve.value[i - 1], b = curve.value[i], c = curve.value[i + 1];
  const double bend = a - 2 * b + c;
  return bend == 0 ? b : b - (c - a) * (c - a) / (8 * bend);
}

struct Extremes {
  std::vector<double> zeros;
  TimeCurve amplitudes;  ///< logarithms
};

Extremes extremes_of(const TimeCurve& curve) {
  Extremes found;
  size_t since = 0;
  for (size_t i = 1; i < curve.time.size(); ++i) {
    const double a = curve.value[i - 1], b = curve.value[i];
    if ((a < 0) == (b < 0)) continue;
    if (!found.zeros.empty()) {
      size_t place = since;
      for (size_t j = since; j < i; ++j)
        if (std::abs(curve.value[j]) > std::abs(curve.value[place])) place = j;
      found.amplitudes.add(curve.time[place], std::log(std::abs(top_of(curve, place))));
    }
    found.zeros.push_back(curve.time[i - 1] + (curve.time[i] - curve.time[i - 1]) * a / (a - b));
    since = i;
  }
  return found;
}

}  // namespace

double TimeCurve::at(double t) const {
  if (t <= time.front()) return value.front();
  const auto after = static_cast<size_t>(std::ranges::lower_bound(time, t) - time.begin());
  if (after == time.size()) return unknown_number;
  const double part = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + part * (value[after] - value[after - 1]);
}

double distance(const TimeCurve& ours, const TimeCurve& reference, double delay) {
  double squares = 0;
  for (size_t i = 0; i < reference.time.size(); ++i) {
    const double off = ours.at(reference.time[i] - delay) - reference.value[i];
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(reference.time.size())) / std::ranges::max(reference.value);
}

double fitted_delay(const TimeCurve& ours, const TimeCurve& reference, double least, double most) {
  // Between straight pieces there may be several minima; a fine search misses none that matters.
  constexpr int tries = 2000;
  double best = least, smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= tries; ++i) {
    const double delay = least + (most - least) * i / tries;
    const double off = distance(ours, reference, delay);
    if (off < smallest) {
      smallest = off;
      best = delay;
    }
  }
  return best;
}

Oscillation oscillation_of(const TimeCurve& curve) {
  const auto [zeros, amplitudes] = extremes_of(curve);
  if (zeros.size() < 3) return {unknown_number, unknown_number};
  const double period = 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  return {period, 1 - std::exp(slope_of(amplitudes) * period)};
}

double slope_of(const TimeCurve& curve) {
  const auto count = static_cast<double>(curve.time.size());
  double time = 0, value = 0;
  for (size_t i = 0; i < curve.time.size(); ++i) {
    time += curve.time[i] / count;
    value += curve.value[i] / count;
  }
  double above = 0, below = 0;
  for (size_t i = 0; i < curve.time.size(); ++i) {
    above += (curve.time[i] - time) * (curve.value[i] - value);
    below += (curve.time[i] - time) * (curve.time[i] - time);
  }
  return above / below;
}

}  // namespace sluice::study
