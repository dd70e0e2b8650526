// Hard cases as tests: each on each backend.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "studies/run_case.hpp"

namespace sluice::test {

using namespace study;

struct HardRun {
  HardCase hard;
  bool on_gpu = false;

  /// Name of the test.
  std::string name() const { return hard.name + (on_gpu ? "_gpu" : "_cpu"); }
};

inline void PrintTo(const HardRun& run, std::ostream* out) { *out << run.name(); }

/// Every case that is quick, or every one that is not, on both backends.
std::vector<HardRun> hard_runs(bool quick);

/// Runs the case and expects what it expects, nothing but numbers in its last state, and on an OpenGL that
/// the processor draws the very result of the CPU.
void expect_as_expected(const HardRun& run);

}  // namespace sluice::test
