// What scripts/bench_gpu found out about correctness before it took times: the log of the test suite and the
// files of `sluice agree`. A page with good times and bad findings must say so.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sluice::bench {

struct Finding {
  bool good = false;
  std::string markdown;  ///< whole lines
};

/// The verdict of ctest in its log, with the tests that failed. A log without a verdict is not good.
Finding read_test_log(const std::filesystem::path& log);

/// Tables of how far the GPU agrees with the CPU: each run as a whole, and every stage. A file that is not
/// there or cannot be read is not good.
Finding read_agreement(const std::vector<std::filesystem::path>& files);

}  // namespace sluice::bench
