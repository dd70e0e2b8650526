// Runs a hard case and says what came of it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/output/summary.hpp"
#include "studies/hard_case.hpp"

namespace sluice::study {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What came of a run. Numbers that make no sense for it are `unknown`.
struct CaseResult {
  std::string backend;
  Outcome outcome = Outcome::survived;
  std::string reason;              ///< why it was stopped or refused
  std::optional<Failure> failure;  ///< where, if it was stopped
  bool warned = false;
  double time = 0;
  RunStatistics statistics;
  /// Kinetic energy of the start, and the mass times the range of the potential.
  double energy_scale = unknown;
  double energy_drift = unknown, energy_gain = unknown;  ///< at the end, and the largest; of energy_scale
  double kinetic_end = unknown;                          ///< of energy_scale
  double level_drift = unknown;                          ///< twice the rise of the mean height, in spacings
  double rise = unknown;     ///< of the highest particle over that of the start, in spacings
  double closest = unknown;  ///< distance of the closest two particles at the end, if asked for
  uint32_t list_growths = 0;
  std::optional<bool> same_bits;  ///< as the scene that it is to equal
  Snapshot end;                   ///< the last state
};

/// Runs the case to its end on `backend`, as `sluice run` would. Throws EnvironmentError when the machine
/// fails.
CaseResult run_case(const HardCase& hard, Backend& backend);

/// How the result differs from what is expected; nothing if it does not.
std::vector<std::string> faults(const HardCase& hard, const CaseResult& result);

/// Distance of the closest two of these points; infinite for fewer.
double closest_distance(const std::vector<Vec2>& points);

}  // namespace sluice::study
