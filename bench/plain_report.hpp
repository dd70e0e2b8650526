// Each plain stage beside the one that a run takes, with the widest instructions.
#pragma once

#include <string>

#include "bench/report.hpp"

namespace sluice::bench {

/// Registers stages and sweeps with both.
void add_plain_benchmarks();

/// Nanoseconds per particle of both, and how many times longer the plain stage takes.
std::string plain_tables(const Collector& times);

}  // namespace sluice::bench
