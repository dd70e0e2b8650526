// The page of docs/results about one GPU: what was found out about correctness, and the times.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/findings.hpp"
#include "bench/gpu_times.hpp"

namespace sluice::bench {

/// What was measured at one size, or why nothing was.
struct SizeTimes {
  uint32_t size = 0;
  std::map<PressureMethod, StepTimes> steps;  ///< of all methods, or of none
  std::string left_out;
};

struct GpuReport {
  std::string renderer, driver, date, processor, compiler;
  bool software = false;
  int threads = 0;                          ///< of the processor
  std::optional<double> others;             ///< processors that other programs had meanwhile
  double copy = 0, bytes = 0;               ///< of the device: bytes per second; bytes of a copy
  std::optional<Finding> tests, agreement;  ///< none: not looked for
  std::vector<SizeTimes> sizes;
  SizeTimes cpu;  ///< with all threads
  std::vector<SweepTimes> compared;
  std::vector<StepPair> small;  ///< sizes between which `--backend auto` should switch, in ascending order
};

/// Number of particles from which on the GPU is the faster one at all sizes measured; none if it never is.
std::optional<uint32_t> faster_from(const std::vector<StepPair>& sizes);

/// "llvmpipe", "NVIDIA H100 80GB HBM3": the renderer as OpenGL names it, without the rest.
std::string short_name(const std::string& renderer);
/// Name of the file for a renderer: "nvidia-h100-80gb-hbm3.md".
std::string page_name(const std::string& renderer);

std::string gpu_page(const GpuReport& report);

}  // namespace sluice::bench
