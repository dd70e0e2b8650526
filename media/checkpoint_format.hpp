// How a checkpoint lies on the disk; docs/output.md describes it.
#pragma once

#include <array>

#include "core/simulation_state.hpp"
#include "core/summary.hpp"
#include "media/checked_file.hpp"

namespace sluice::checkpoint {

inline constexpr std::string_view magic = "sluice checkpoint";
inline constexpr FileKind kind{magic, 1, "checkpoint", "`sluice run --checkpoint`",
                               "copy it again, go on from an earlier one or run the scene from its start"};

/// Between the header and the particles.
struct Facts {
  uint64_t particles = 0;
  RunClock clock;
  RunCounts counts;
  /// Of the last step, in the order of Diagnostics; `lost` is that of the counts.
  std::array<double, 12> diagnostics{};
};
static_assert(sizeof(Facts) == 8 + 5 * 8 + 10 * 8 + 12 * 8, "no bytes that nobody sets");

inline constexpr size_t values_per_particle = 6;  // x y of all, vx vy of all, then density, then pressure

}  // namespace sluice::checkpoint
