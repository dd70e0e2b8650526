// Speed against error: what a simulated second costs with every method, solver, tolerance and time step, and
// how far off it is.
#pragma once

#include <string>
#include <vector>

#include "studies/study.hpp"

namespace sluice::study {

std::vector<Point> pareto_points();
Report pareto_report(const std::vector<Result>& results);

/// A run as a point of the picture.
struct Trade {
  std::string scene, family;  ///< family: what is compared at equal error
  std::string curve, label;   ///< of runs that differ in their time step; and of this run
  double seconds = 0;         ///< of computation per unit of simulated time
  double error = 0;
};

/// The cheapest run of a family whose error is at most that of the target.
struct Cheapest {
  double target = 0;
  std::vector<Trade> by_family;      ///< from the cheapest on
  std::vector<std::string> never{};  ///< families that do not get there
};

std::vector<Cheapest> cheapest_at(const std::vector<Trade>& trades, const std::vector<double>& targets);

/// Who is cheapest, and how many times as long the other families take.
std::string words_for(const Cheapest& cheapest);

/// The largest error of each curve of a family, from the largest on, rounded up by a twentieth: runs that are
/// no worse than these are equals.
std::vector<double> errors_of_curves(const std::vector<Trade>& trades, const std::string& family);

/// The least error above 0; NaN without one.
double least_error(const std::vector<Trade>& trades);

/// Root mean square distance of the displacements of two runs since their starts at the time `at`, in
/// spacings; NaN when one of them has no frame of that time.
double distance_between(const Result& one, const Result& other, double at);

}  // namespace sluice::study
