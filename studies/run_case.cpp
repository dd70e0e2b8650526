// The run of a hard case, and what is measured meanwhile.
#include "studies/run_case.hpp"

#include <algorithm>
#include <cmath>

#include "core/agree/agree.hpp"
#include "core/agree/agreement.hpp"
#include "core/solver/limits.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::study {
namespace {

/// Counts how often the neighbour list becomes longer.
class CountingBackend final : public ForwardingBackend {
 public:
  explicit CountingBackend(Backend& backend) : ForwardingBackend(backend) {}
  void resize_list(uint64_t entries) override {
    ++growths;
    ForwardingBackend::resize_list(entries);
  }
  void sweep(const std::vector<Stage>& stages, uint32_t times) override { active_->sweep(stages, times); }
  uint32_t growths = 0;
};

double highest(const Snapshot& state) {
  double y = -std::numeric_limits<double>::infinity();
  for (const Vec2 x : state.x) y = std::max(y, x.y);
  return y;
}

double mean_height(const Snapshot& state) {
  double sum = 0;
  for (const Vec2 x : state.x) sum += x.y;
  return sum / static_cast<double>(state.x.size());
}

/// Energies and heights, relative to those of the start.
class Watch {
 public:
  Watch(const Scene& scene, const Snapshot& start) : h_(scene.spacing), level_(mean_height(start)) {
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (size_t i = 0; i < start.x.size(); ++i) {
      const double potential = -glm::dot(scene.gravity, start.x[i]);
      kinetic_ += 0.5 * scene.mass() * glm::dot(start.v[i], start.v[i]);
      potential_ += scene.mass() * potential;
      least = std::min(least, potential);
      largest = std::max(largest, potential);
    }
    scale_ = kinetic_ + scene.mass() * static_cast<double>(start.x.size()) * (largest - least);
    top_ = highest(start);
  }

  void add(const Diagnostics& d, CaseResult& result) const {
    result.energy_scale = scale_;
    // The start has what is to be measured against, or there is no telling.
    if (!d.finite() || !(scale_ > 0)) return;
    result.energy_drift = (d.kinetic_energy - kinetic_ + d.potential_energy - potential_) / scale_;
    result.energy_gain = std::fmax(result.energy_gain, result.energy_drift);
    result.kinetic_end = d.kinetic_energy / scale_;
  }

  void add(const Snapshot& state, CaseResult& result) const {
    result.rise = std::fmax(result.rise, (highest(state) - top_) / h_);
    result.level_drift = 2 * (mean_height(state) - level_) / h_;
  }

 private:
  double h_, level_, top_ = 0;
  double kinetic_ = 0, potential_ = 0, scale_ = 0;
};

/// The times at which heights are looked at, beside the end.
constexpr int looks = 20;

struct Run {
  Scene scene;
  Samples samples;
};

Run prepare(const HardCase& hard, const std::string& text) {
  Run run{parse_scene(text, hard.name + ".toml"), {}};
  run.samples = sample(run.scene);
  if (hard.rearrange) hard.rearrange(run.scene, run.samples);
  return run;
}

/// Whether a run is at its end, which is where `sluice run` ends.
bool is_over(const Scene& scene, const Simulator& simulator) {
  if (simulator.failure()) return true;
  if (scene.adaptive) return simulator.time() >= scene.duration;
  return simulator.steps() >= static_cast<uint64_t>(std::round(scene.duration / scene.dt));
}

StepReport step(const Scene& scene, Simulator& simulator) {
  return simulator.step(scene.adaptive ? scene.duration : std::numeric_limits<double>::infinity());
}

void simulate(const HardCase& hard, Backend& backend, CaseResult& result) {
  const Run run = prepare(hard, hard.scene);
  const Scene& scene = run.scene;
  result.warned = !beyond_limits(scene, run.samples).empty();
  CountingBackend counting(backend);
  Simulator simulator(scene, run.samples, counting);
  const Watch watch(scene, simulator.snapshot());
  int looked = 0;
  while (!is_over(scene, simulator)) {
    const StepReport report = step(scene, simulator);
    result.statistics.add(report);
    watch.add(report.diagnostics, result);
    if (report.time < scene.duration * (looked + 1) / looks) continue;
    ++looked;
    watch.add(simulator.snapshot(), result);
  }
  result.end = simulator.snapshot();
  watch.add(result.end, result);
  result.time = simulator.time();
  result.list_growths = counting.growths;
  if (hard.expected.closest) result.closest = closest_distance(result.end.x) / scene.spacing;
  result.failure = simulator.failure();
  if (!result.failure) return;
  result.outcome = Outcome::stopped;
  result.reason = result.failure->reason;
}

/// The last state of the scene that a case has to equal, at places that may be other ones.
Snapshot twin_of(const HardCase& hard, Backend& backend) {
  const Run run = prepare(hard, hard.same_as);
  Simulator simulator(run.scene, run.samples, backend);
  while (!is_over(run.scene, simulator)) step(run.scene, simulator);
  return simulator.snapshot();
}

}  // namespace

CaseResult run_case(const HardCase& hard, Backend& backend) {
  CaseResult result;
  result.backend = backend.name();
  try {
    simulate(hard, backend, result);
    if (!hard.same_as.empty()) {
      Snapshot twin = twin_of(hard, backend);
      twin.x = result.end.x;
      result.same_bits = same_bits(twin, result.end);
    }
  } catch (const InputError& error) {
    result.outcome = Outcome::refused;
    result.reason = error.what();
  }
  return result;
}

double closest_distance(const std::vector<Vec2>& points) {
  std::vector<Vec2> sorted = points;
  std::sort(sorted.begin(), sorted.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  double closest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < sorted.size(); ++i) {
    for (size_t j = i + 1; j < sorted.size() && sorted[j].x - sorted[i].x < closest; ++j)
      closest = std::min(closest, glm::length(sorted[j] - sorted[i]));
  }
  return closest;
}

}  // namespace sluice::study
