// What pressure costs: the two tables of [Hunkler 2022, section 6.4], theirs beside ours, and its verdicts.
#pragma once

#include <string>
#include <vector>

#include "studies/study.hpp"

namespace sluice::study {

std::vector<Point> cost_points();
Report cost_report(const std::vector<Result>& results);

/// A row of the thesis's tables.
struct Published {
  const char *scene, *method;  ///< "IISPH" or "SSPH"
  const char* dt;
  double iterations, pressure_seconds, step_seconds;  ///< NaN where the thesis has none
};
const std::vector<Published>& published_costs();

/// What a run took: the fastest of those that were made.
struct Cost {
  std::string scene, method, dt;  ///< method with its solver
  double iterations = 0, pressure_seconds = 0, step_seconds = 0;
  double compression = 0, cfl_max = 0, lost = 0;
  bool valid = true;
};

/// SSPH on the breaking dam from starts that differ by a millionth of a spacing.
struct Starts {
  std::string dt;
  int starts = 0, with_losses = 0;
  double cfl_max = 0;  ///< of all
};

/// The table of what the thesis concludes.
TextTable cost_verdicts(const std::vector<Cost>& costs, const std::vector<Starts>& starts);

}  // namespace sluice::study
