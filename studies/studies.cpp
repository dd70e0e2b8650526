// The list of studies.
#include "studies/cost.hpp"
#include "studies/density.hpp"
#include "studies/pareto.hpp"
#include "studies/study.hpp"
#include "studies/timestep.hpp"
#include "studies/validation.hpp"

namespace sluice::study {

const std::vector<Study>& studies() {
  static const std::vector<Study> all{
      {"timestep", "largest time steps over spacing, stiffness and viscosity [Hunkler 2022, section 6.2]",
       timestep_points, timestep_report},
      {"density", "mean density of a resting fluid over time [Hunkler 2022, section 6.3]", density_points,
       density_report},
      {"cost", "what pressure costs, and what follows from it [Hunkler 2022, section 6.4]", cost_points,
       cost_report},
      {"validate", "cases with a known answer: error, order and limit of every method", validation_points,
       validation_report},
      {"pareto", "seconds of computation against error, of every method, solver and tolerance", pareto_points,
       pareto_report},
  };
  return all;
}

}  // namespace sluice::study
