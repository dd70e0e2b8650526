// Curves over time, and how far one is from another.
#pragma once

#include <vector>

namespace sluice::study {

/// Values at ascending times, two or more.
struct TimeCurve {
  std::vector<double> time, value;

  void add(double t, double v) {
    time.push_back(t);
    value.push_back(v);
  }
  /// On the line between two values. Before the start the first value; NaN after the end.
  double at(double t) const;
};

/// Root of the mean square of ours(t - delay) - reference(t), at the times of the reference, relative to the
/// largest value of the reference.
double distance(const TimeCurve& ours, const TimeCurve& reference, double delay = 0);

/// The delay between `least` and `most` for which the distance is smallest, to a two-thousandth of the range.
double fitted_delay(const TimeCurve& ours, const TimeCurve& reference, double least, double most);

/// A decaying oscillation around 0.
struct Oscillation {
  double period = 0;
  double loss = 0;  ///< part of the amplitude that a period takes
};

/// From where the curve passes 0, and the extremes between. NaN where it has fewer than three zeros.
Oscillation oscillation_of(const TimeCurve& curve);

/// Slope of the line of least squares.
double slope_of(const TimeCurve& curve);

}  // namespace sluice::study
