// A hard case: a scene that is likely to go wrong, and what has to come of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"
#include "studies/hard_scenes.hpp"

namespace sluice::study {

/// A run is valid to its end (exit code 0), becomes invalid (1), or its scene is refused (2).
enum class Outcome { survived, stopped, refused };
std::string_view name_of(Outcome outcome);

/// What has to come out. Bounds are of a run that survives.
struct Expectation {
  Outcome outcome = Outcome::survived;
  bool may_be_stopped = false;  ///< too: which of the two comes out is chance
  std::string reason;           ///< a part of why it is stopped or refused
  bool warned = false;          ///< something is said before the first step
  uint64_t stopped_by = 0;      ///< the last step in which it may be stopped; 0 for any
  uint32_t lost = 0;            ///< particles, at most
  std::optional<uint32_t> least_lost;
  std::optional<double> energy_gain;       ///< over the start, relative to CaseResult::energy_scale
  std::optional<double> mean_compression;  ///< mean over the steps
  std::optional<double> rise;              ///< spacings above the highest particle of the start
  std::optional<double> level_drift;       ///< spacings, either way
  std::optional<double> kinetic_end;       ///< relative to energy_scale
  std::optional<double> closest;           ///< spacings between the closest two particles, at least
  std::optional<uint32_t> list_growths;    ///< times the neighbour list became longer
};

/// What runs are stopped for that blow up: more than 100 spacings in a step, or more than 10 % lost; and such
/// with adaptive steps.
inline constexpr const char *blown_up = "more than 10", *collapsed = "the time step collapsed";

/// It has to be stopped for this; or it may be.
void expect_stop(Expectation& expected, const char* reason);
void allow_stop(Expectation& expected, const char* reason);

struct HardCase {
  std::string name;    ///< that of its scene file
  std::string method;  ///< for people
  std::string scene;   ///< what is in its scene file
  /// What no scene file can say: changes the samples before the run.
  std::function<void(const Scene&, Samples&)> rearrange;
  /// A scene in which the same particles have to have the same bits of velocity, density and pressure.
  std::string same_as;
  bool quick = false;  ///< a moment on the CPU, and chosen for the tests that always run
  Expectation expected;
};

/// The expectation in words: "survives, lost <= 0", "stopped: crowd together".
std::string text_of(const Expectation& expected);

/// Puts cases together.
class HardCases {
 public:
  /// A case named `topic` and after the method of its scene. Valid until the next one is added.
  HardCase& add(const std::string& topic, const SceneParts& parts);
  /// The same with a scene of any text.
  HardCase& add(const std::string& name, const std::string& method, const std::string& scene);
  std::vector<HardCase> take() { return std::move(cases_); }

 private:
  std::vector<HardCase> cases_;
};

/// All of them, in the order of docs/results/hard_cases.md.
std::vector<HardCase> hard_cases();

// By topic; each adds its own.
void add_deep_water(HardCases& cases);      ///< columns, films and tanks at rest
void add_time_steps(HardCases& cases);      ///< beyond CFL and viscous limits, adaptive steps
void add_few_particles(HardCases& cases);   ///< one, two, some, lines
void add_crowded_starts(HardCases& cases);  ///< coincident, compressed, driven into one place
void add_impacts(HardCases& cases);         ///< floors, jets on thin walls, fluids that are too soft
void add_places(HardCases& cases);          ///< walls and grid out of line, far away, strays, cell edges
void add_numbers(HardCases& cases);         ///< NaN and numbers of any size

}  // namespace sluice::study
