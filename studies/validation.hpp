// Validation: cases with a known answer, at three resolutions, by every method that can run them, on every
// backend.
#pragma once

#include <string>
#include <vector>

#include "studies/study.hpp"

namespace sluice::study {

/// Something of a run that is known.
struct Measure {
  std::string quantity;
  double ours = 0, reference = 0;  ///< in the units of the case; NaN where a single number says nothing
  double error = 0;                ///< 0 or more, relative to what the case says
};

/// What the error of the best method may be at N = 40; and at the finest resolution, as an aim. 0: no limit.
struct Limit {
  std::string quantity;
  double at_40 = 0, at_finest = 0;
};

/// A method with its settings, at N particles per unit of length.
struct Variant {
  std::string name;   ///< of files: "iisph", "iisph_smoothed"
  std::string label;  ///< for people: "IISPH, smoothing 1.2"
  std::vector<std::string> (*overrides)(int n);
};

struct ValidationCase {
  std::string name;   ///< of its scene in scenes/validation
  double length = 1;  ///< the spacing is length / N
  std::vector<Limit> limits;
  bool exact = false;  ///< limits are for every method, not for the best
  std::vector<Variant> variants;
  std::vector<std::string> words = {};  ///< further words of `sluice run`
  bool series = false, recording = false;
  /// Of a run that is valid.
  std::vector<Measure> (*measure)(const Result&) = nullptr;
};

const std::vector<ValidationCase>& validation_cases();

// By topic.
std::vector<ValidationCase> drop_cases();   ///< without walls: drops, exact motions
std::vector<ValidationCase> water_cases();  ///< with walls: tank, dam, wave

std::vector<Point> validation_points();
Report validation_report(const std::vector<Result>& results);

}  // namespace sluice::study
