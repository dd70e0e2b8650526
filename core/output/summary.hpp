// What remains of a run when it is over: counts, means, extremes, timings; for people and as JSON.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/solver/simulator.hpp"
#include "core/stopwatch.hpp"

namespace sluice {

/// Sums and counts that means and extremes are made of. They are kept whole in checkpoints, so a change of
/// them is a change of their format.
struct RunCounts {
  uint64_t steps = 0, iterations = 0, not_converged = 0, repeats = 0;
  uint32_t iterations_max = 0, lost = 0;
  double compression_sum = 0, compression_max = 0, cfl_max = 0;
  double dt_min = std::numeric_limits<double>::infinity(), dt_max = 0;
};

/// Means and extremes over the steps of a run, those before a checkpoint included.
class RunStatistics {
 public:
  /// Statistics that go on from `before`, the steps that led to the checkpoint from which the run goes on.
  explicit RunStatistics(const RunCounts& before = {}) : counts_(before), before_(before) {}
  void add(const StepReport& report);

  uint64_t steps() const { return counts_.steps; }
  uint64_t iterations() const { return counts_.iterations; }
  double iterations_mean() const { return mean(static_cast<double>(counts_.iterations)); }
  uint32_t iterations_max() const { return counts_.iterations_max; }
  uint64_t not_converged() const { return counts_.not_converged; }
  double compression_mean() const { return mean(counts_.compression_sum); }
  double compression_max() const { return counts_.compression_max; }
  double cfl_max() const { return counts_.cfl_max; }
  uint32_t lost() const { return counts_.lost; }
  double dt_min() const { return counts_.dt_min; }
  double dt_max() const { return counts_.dt_max; }
  /// Number of times that an adaptive step was done again with a shorter dt.
  uint64_t repeats() const { return counts_.repeats; }

  const RunCounts& counts() const { return counts_; }
  const RunCounts& before() const { return before_; }

 private:
  double mean(double sum) const { return steps() == 0 ? 0 : sum / static_cast<double>(steps()); }

  RunCounts counts_, before_;
};

struct RunSummary {
  const Scene& scene;
  const Samples& samples;
  const Backend& backend;
  const Simulator& simulator;
  const RunStatistics& statistics;
  const Stopwatch& watch;  ///< of the steps made here, loading and output excluded
  std::string start_from;  ///< checkpoint whose particles it started with; empty if they were the scene's own
};

/// Summary as JSON, settings included; numbers that are not finite become null.
nlohmann::ordered_json to_json(const RunSummary& summary);

/// Summary for people: a few lines, and the table of time per stage.
std::string to_text(const RunSummary& summary);

}  // namespace sluice
