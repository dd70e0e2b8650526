// The largest time step that keeps cfl <= 1 throughout a breaking dam, over spacing, stiffness and viscosity:
// [Hunkler 2022, section 6.2, Figs. 6.6 to 6.8].
#pragma once

#include <string>
#include <vector>

#include "studies/study.hpp"

namespace sluice::study {

std::vector<Point> timestep_points();
Report timestep_report(const std::vector<Result>& results);

/// A run of the grid of time steps.
struct Trial {
  double dt = 0;
  int start = 0;    ///< which of the jittered ones
  double cfl = 0;   ///< the largest; infinite where the run became invalid
  double lost = 0;  ///< particles
};

/// The largest time steps of a grid that pass, which are not all of those below them.
struct StepLimit {
  double dt = 0;      ///< the median over the starts of the largest cfl is at most 1; 0 where none is
  double steady = 0;  ///< the same of the steps up to which every smaller one of the grid passes, too
  double least = 0, most = 0;  ///< over the starts, of the largest step with which that start passes
  double lost = 0;             ///< particles, the median over the starts at that step
  size_t starts = 0;           ///< of that step
  bool at_the_end = false;     ///< the largest of the grid passes, so the limit may be beyond it
};

/// Of the trials of one configuration.
StepLimit step_limit(const std::vector<Trial>& trials);

/// The exponent b of y = a x^b, by least squares of the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace sluice::study
