// What came of a case against what is expected of it.
#include <fmt/format.h>

#include <cmath>

#include "core/solver/verdict.hpp"
#include "studies/run_case.hpp"

namespace sluice::study {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Faults {
 public:
  /// `value` has to be at most `bound`, if there is one; what is no number is not.
  template <class T, class Bound>
  void at_most(const char* what, T value, const std::optional<Bound>& bound) {
    if (bound && !(value <= static_cast<T>(*bound)))
      found.push_back(fmt::format("{} is {:g}, above {:g}", what, static_cast<double>(value),
                                  static_cast<double>(*bound)));
  }
  template <class T, class Bound>
  void at_least(const char* what, T value, const std::optional<Bound>& bound) {
    if (bound && !(value >= static_cast<T>(*bound)))
      found.push_back(fmt::format("{} is {:g}, below {:g}", what, static_cast<double>(value),
                                  static_cast<double>(*bound)));
  }
  std::vector<std::string> found;
};

/// Of a run that survived.
void judge_end(const Expectation& expected, const CaseResult& result, Faults& faults) {
  faults.at_most("lost", result.statistics.lost(), std::optional(expected.lost));
  faults.at_least("lost", result.statistics.lost(), expected.least_lost);
  faults.at_most("the energy gain", result.energy_gain, expected.energy_gain);
  faults.at_most("the mean compression", result.statistics.compression_mean(), expected.mean_compression);
  faults.at_most("the rise", result.rise, expected.rise);
  faults.at_most("the level drift", std::abs(result.level_drift), expected.level_drift);
  faults.at_most("the kinetic energy", result.kinetic_end, expected.kinetic_end);
  faults.at_least("the closest distance", result.closest, expected.closest);
  faults.at_most("list growths", result.list_growths, expected.list_growths);
}

/// A run that was stopped has to say where: in the last step it made, which particle of its own, at a place.
void judge_failure(const Expectation& expected, const CaseResult& result, Faults& faults) {
  const Failure& failure = *result.failure;
  if (failure.step != result.statistics.steps() || failure.id >= result.end.x.size() ||
      !std::isfinite(failure.x.x) || !std::isfinite(failure.x.y))
    faults.found.push_back("it does not say where it was stopped");
  if (expected.stopped_by > 0) faults.at_most("the step", failure.step, std::optional(expected.stopped_by));
}

}  // namespace

std::vector<std::string> faults(const HardCase& hard, const CaseResult& result) {
  const Expectation& expected = hard.expected;
  Faults faults;
  const bool by_chance = expected.may_be_stopped && result.outcome == Outcome::stopped;
  if (result.outcome != expected.outcome && !by_chance) {
    faults.found.push_back(
        fmt::format("{}{}{}", name_of(result.outcome), result.reason.empty() ? "" : ": ", result.reason));
    return faults.found;
  }
  if (result.outcome != Outcome::survived && !has(result.reason, expected.reason))
    faults.found.push_back(result.reason);
  if (result.warned != expected.warned) faults.found.push_back(result.warned ? "warned" : "not warned");
  if (result.outcome != Outcome::refused && !is_finite(result.end))
    faults.found.push_back("its last state is not finite");
  if (result.outcome == Outcome::survived && !expected.may_be_stopped) judge_end(expected, result, faults);
  if (result.outcome == Outcome::stopped) judge_failure(expected, result, faults);
  if (result.same_bits == false) faults.found.push_back("its bits are not those of its twin");
  return faults.found;
}

}  // namespace sluice::study
