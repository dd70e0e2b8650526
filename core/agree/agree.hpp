// Do two backends agree? Every stage from identical input, a whole run beside the other, and a run of one of
// them beside itself, stage by stage.
#pragma once

#include <optional>
#include <vector>

#include "core/agree/agreement.hpp"
#include "sluice/report.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Tolerance of stages on graphics cards, in units in the last place of a field's largest value.
inline constexpr double hardware_tolerance = 32;

struct StageAgreement {
  Stage stage = Stage::count;
  Difference difference;
  bool pass = false;
};

struct RunAgreement {
  uint64_t steps = 0;                  ///< how many both made
  bool equal = true;                   ///< states after every step, to the last bit
  uint64_t first_difference_step = 0;  ///< 0: none
  double max_dx_over_h = 0;            ///< largest distance between two places of a particle, over all steps
  bool iterations_equal = true;
  /// Failure of the reference's run, or of the other's, in the last of these steps.
  std::optional<Failure> reference_failure, other_failure;

  /// Whether both runs end alike and, unless there is a tolerance, with equal states.
  bool passes(double tolerance) const {
    const bool ended_alike = reference_failure.has_value() == other_failure.has_value();
    return ended_alike && (tolerance > 0 || (equal && iterations_equal));
  }
};

struct Agreement {
  std::vector<StageAgreement> stages;
  RunAgreement run;
  /// Agreement of the other's run with itself stage by stage, which has to be exact on every device.
  std::optional<RunAgreement> stepped;
  double tolerance = 0;  ///< tolerance of the stages, in units in the last place of a field's largest value
  bool pass = false;
};

/// Whether two states are the same to the last bit.
bool same_bits(const Snapshot& a, const Snapshot& b);

/// Backends that are held against each other.
struct Contestants {
  Backend& reference;                ///< runs alone, and compares its stages with
  Backend& stage_other;              ///< computes the stages that are compared; never runs by itself
  Backend& run_other;                ///< runs beside the reference
  Backend* stepped_other = nullptr;  ///< of the same device: runs beside that one, stage by stage
};

/// Runs `steps` >= 1 steps. Stages are compared in the first step, in the middle and in the last. With
/// tolerance 0 the runs have to be equal too; otherwise they only have to end alike, since after an impact
/// the smallest difference grows without bound. What a device does wrong in a whole run only, such as not to
/// wait, shows all the same in its comparison with itself.
Agreement agree(const Scene& scene, const Samples& samples, const Contestants& contestants, uint64_t steps,
                double tolerance);

/// Comparison of one stage with itself on another backend.
struct StageTrial {
  StageAgreement agreement;
  uint64_t steps = 0;                ///< steps in which it was compared
  std::vector<WatchedField> fields;  ///< their values in the last comparison
  std::optional<Failure> failure;    ///< that ended the run
};

/// Runs `steps` >= 1 steps on `reference` and in each of them `stage` on `other` too, from the same input.
/// The values of `fields` are those of the last step, or of the last sweep in it.
StageTrial try_stage(const Scene& scene, const Samples& samples, Backend& reference, Backend& other,
                     Stage stage, FieldSet fields, uint64_t steps, double tolerance);

}  // namespace sluice
