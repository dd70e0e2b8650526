// The scenes of the study `pareto`, and what its points and its report have in common.
#pragma once

#include <string>
#include <vector>

#include "studies/validation.hpp"

namespace sluice::study {

struct ParetoScene {
  const char* name;      ///< that of its case of validation
  const char* quantity;  ///< the error against the case's own reference
  double stiffness;      ///< k and kappa with which the fluid is compressed by about 1 %
  double longest;        ///< IISPH's largest dt, in spacings
  double before_chaos;   ///< when runs are compared with a converged one; 0: they are not
  bool free_surface;     ///< where a relaxed start helps
  /// What a state equation needs at its walls, at N particles per unit of length: the second term of the
  /// mirrored pressure gives energy to it.
  std::vector<std::string> (*calmed)(int n);

  const ValidationCase& validation() const;
};

const std::vector<ParetoScene>& pareto_scenes();

namespace pareto {
/// Particles per unit of length: on the CPU, and where there is a GPU too.
inline constexpr int fine = 40, coarse = 20;
inline constexpr const char *on_double = "CPU, double", *on_float = "CPU, float", *on_gpu = "GPU";
/// The family of the runs that others are compared with.
inline constexpr const char* converged = "converged";
}  // namespace pareto

}  // namespace sluice::study
