// `sluice_bench --gpu`: times the GPU backend and writes the page about it.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace sluice::bench {

struct GpuOptions {
  std::optional<std::filesystem::path> pages;     ///< the folder that the page goes to; else it is printed
  std::optional<std::filesystem::path> test_log;  ///< of ctest
  std::vector<std::filesystem::path> agreement;   ///< summaries of `sluice agree`
};

/// Returns false when tests failed or the GPU disagrees; the page says so.
bool report_gpu(const GpuOptions& options);

}  // namespace sluice::bench
