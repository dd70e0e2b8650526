// How a checkpoint lies on the disk; docs/output.md describes it.
#pragma once

#include <array>

#include "core/output/checked_file.hpp"
#include "core/output/summary.hpp"
#include "core/solver/simulation_state.hpp"

namespace sluice {

inline constexpr std::string_view checkpoint_magic = "sluice checkpoint";
inline constexpr FileKind checkpoint_file_kind{
    checkpoint_magic, 1, "checkpoint", "`sluice run --checkpoint`",
    "copy it again, go on from an earlier one or run the scene from its start"};

/// Numbers between the header and the particles.
struct CheckpointFacts {
  uint64_t particles = 0;
  RunClock clock;
  RunCounts counts;
  /// Diagnostics of the last step, in their order; `lost` is that of the counts.
  std::array<double, 12> diagnostics{};
};
static_assert(sizeof(CheckpointFacts) == 8 + 5 * 8 + 10 * 8 + 12 * 8, "no bytes that nobody sets");

inline constexpr size_t checkpoint_values_per_particle =
    6;  // x y of all, vx vy of all, then density, then pressure

}  // namespace sluice
