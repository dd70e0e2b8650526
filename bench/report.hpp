// The measurements as Markdown tables.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "core/stopwatch.hpp"

namespace sluice::bench {

/// Prints what runs as usual, and keeps the fastest repetition of each.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector();

  void ReportRuns(const std::vector<Run>& runs) override;

  bool failed() const { return failed_; }
  /// Machine, copy bandwidth, sweeps, steps and stages; what was not measured is left out or stands as a
  /// dash.
  std::string markdown() const;
  /// The counter of a benchmark; NaN when it was not run.
  double number(const std::string& name, const std::string& counter) const;

 private:
  std::string wcsph_tables() const;

  std::map<std::string, std::map<std::string, double>> best_;  ///< counters by the benchmark's name
  Stopwatch watch_;
  std::size_t repetitions_ = 1;
  bool failed_ = false;
};

}  // namespace sluice::bench
