// Two simulators in step.
#include "core/agree/agree.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/solver/simulator.hpp"

namespace sluice {
namespace {

template <class T>
bool equal_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

double largest_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double distance = glm::length(a[i] - b[i]);
    if (!(distance <= largest)) largest = distance;  // keeps NaN
  }
  return largest;
}

void compare_step(const StepReport& a, const StepReport& b, const Simulator& reference,
                  const Simulator& other, double spacing, RunAgreement& run) {
  run.steps = a.step;
  run.iterations_equal = run.iterations_equal && a.iterations == b.iterations;
  const Snapshot x = reference.snapshot(), y = other.snapshot();
  const bool both_valid = !reference.failure() == !other.failure();
  if (same_bits(x, y) && both_valid) return;
  if (run.equal) run.first_difference_step = a.step;
  run.equal = false;
  const double dx = largest_distance(x.x, y.x) / spacing;
  run.max_dx_over_h = dx <= run.max_dx_over_h ? run.max_dx_over_h : dx;
}

void note_ends(const Simulator& reference, const Simulator& other, RunAgreement& run) {
  run.reference_failure = reference.failure();
  run.other_failure = other.failure();
}

}  // namespace

bool same_bits(const Snapshot& a, const Snapshot& b) {
  return equal_bytes(a.x, b.x) && equal_bytes(a.v, b.v) && equal_bytes(a.density, b.density) &&
         equal_bytes(a.pressure, b.pressure);
}

Agreement agree(const Scene& scene, const Samples& samples, const Contestants& contestants, uint64_t steps,
                double tolerance) {
  ComparingBackend comparing(contestants.reference, contestants.stage_other);
  Simulator reference(scene, samples, comparing), other(scene, samples, contestants.run_other);
  std::optional<SteppedBackend> one_by_one;
  std::optional<Simulator> stepped;
  Agreement result;
  if (contestants.stepped_other != nullptr) {
    one_by_one.emplace(*contestants.stepped_other);
    stepped.emplace(scene, samples, *one_by_one);
    result.stepped.emplace();
  }
  result.tolerance = tolerance;
  for (uint64_t step = 1; step <= steps && !reference.failure() && !other.failure(); ++step) {
    comparing.compare_from_now_on(step == 1 || step == (steps + 1) / 2 || step == steps);
    const StepReport a = reference.step(), b = other.step();
    compare_step(a, b, reference, other, scene.spacing, result.run);
    if (stepped && !stepped->failure())
      compare_step(stepped->step(), b, *stepped, other, scene.spacing, *result.stepped);
  }
  note_ends(reference, other, result.run);
  result.pass = result.run.passes(tolerance);
  if (stepped) {
    note_ends(*stepped, other, *result.stepped);
    result.pass = result.pass && result.stepped->passes(0);
  }
  for (uint32_t i = 0; i < stage_count; ++i) {
    const Difference& difference = comparing.difference(static_cast<Stage>(i));
    if (difference.values == 0) continue;
    const bool pass = difference.within(tolerance);
    result.stages.push_back({static_cast<Stage>(i), difference, pass});
    result.pass = result.pass && pass;
  }
  return result;
}

StageTrial try_stage(const Scene& scene, const Samples& samples, Backend& reference, Backend& other,
                     Stage stage, FieldSet fields, uint64_t steps, double tolerance) {
  ComparingBackend comparing(reference, other);
  comparing.watch(stage, fields);
  Simulator simulator(scene, samples, comparing);
  comparing.compare_from_now_on(true);
  while (simulator.steps() < steps && !simulator.failure()) simulator.step();
  const Difference& difference = comparing.difference(stage);
  return {{stage, difference, difference.within(tolerance)},
          simulator.steps(),
          comparing.watched(),
          simulator.failure()};
}

}  // namespace sluice
