// The benchmarks by file. Names are METHOD/SIZE/PRECISION/THREADS/WHAT; bench/report.cpp reads them back.
#pragma once

#include <memory>

#include "bench/cases.hpp"

namespace sluice::bench {

/// Every stage of the plan; those that sort particles into the grid as one group "grid" with counters for
/// each.
void add_stage_benchmarks(const CaseKey& key, const std::shared_ptr<CaseStore>& store);

/// A sweep of IISPH's pressure solve.
void add_sweep_benchmark(const CaseKey& key, const std::shared_ptr<CaseStore>& store);

/// Whole steps; for IISPH also sweeps, and for one thread in float beside them the yardstick's.
void add_step_benchmarks(const CaseKey& key, const std::shared_ptr<CaseStore>& store);

/// Copy of an array much larger than the caches, as in STREAM [McCalpin 1995]: what memory can give. And
/// reading one that fits into the last-level cache.
void add_bandwidth_benchmarks(int threads);

}  // namespace sluice::bench
