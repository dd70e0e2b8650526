// What remains of a run when it is over: counts, means, extremes, timings; for people and as JSON.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "core/simulator.hpp"

namespace sluice {

/// Means and extremes over the steps of a run.
class RunStatistics {
 public:
  void add(const StepReport& report);

  uint64_t steps() const { return steps_; }
  uint64_t iterations() const { return iterations_; }
  double iterations_mean() const { return mean(static_cast<double>(iterations_)); }
  uint32_t iterations_max() const { return iterations_max_; }
  uint64_t not_converged() const { return not_converged_; }
  double compression_mean() const { return mean(compression_sum_); }
  double compression_max() const { return compression_max_; }
  double cfl_max() const { return cfl_max_; }
  uint32_t lost() const { return lost_; }
  double dt_min() const { return dt_min_; }
  double dt_max() const { return dt_max_; }
  /// Times an adaptive step was done again with a shorter dt.
  uint64_t repeats() const { return repeats_; }

 private:
  double mean(double sum) const { return steps_ == 0 ? 0 : sum / static_cast<double>(steps_); }

  uint64_t steps_ = 0, iterations_ = 0, not_converged_ = 0, repeats_ = 0;
  uint32_t iterations_max_ = 0, lost_ = 0;
  double compression_sum_ = 0, compression_max_ = 0, cfl_max_ = 0;
  double dt_min_ = std::numeric_limits<double>::infinity(), dt_max_ = 0;
};

struct RunSummary {
  const Scene& scene;
  const Samples& samples;
  const Backend& backend;
  const Simulator& simulator;
  const RunStatistics& statistics;
  double seconds = 0;  ///< wall time of the steps, loading and output excluded
};

/// All of it, settings included; numbers that are not finite become null.
nlohmann::ordered_json to_json(const RunSummary& summary);

/// A few lines and the table of time per stage.
std::string to_text(const RunSummary& summary);

/// Version of Sluice.
std::string version();

}  // namespace sluice
