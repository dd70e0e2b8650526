// How a recording lies on the disk; docs/output.md describes it.
#pragma once

#include <array>
#include <cstdint>

#include "core/output/checked_file.hpp"

namespace sluice::media {

inline constexpr std::string_view recording_magic = "sluice recording";
inline constexpr FileKind recording_file_kind{recording_magic, 2, "recording", "`sluice run --record`",
                                              "copy it again or record the run once more"};

/// Entry of the index: where a frame is, and what it shows.
struct IndexEntry {
  uint64_t offset = 0, bytes = 0;
  uint64_t step = 0;
  double time = 0;
};

/// The last bytes of the file.
struct Tail {
  uint64_t index_offset = 0;
  uint64_t frames = 0;
  uint64_t checksum = 0;  ///< XXH3 of everything before the tail, and of the two numbers above
  std::array<char, 8> end{'e', 'n', 'd', ' ', 'o', 'f', ' ', '1'};
};

/// Numbers of a frame before its particles, in this order.
struct FrameFacts {
  uint64_t step = 0;
  uint32_t iterations = 0, converged = 1;
  uint32_t lost = 0, unused = 0;
  double time = 0, dt = 0, residual = 0, seconds_per_step = 0;
  double mean_density = 0, mean_compression = 0, max_compression = 0;
  double kinetic_energy = 0, potential_energy = 0;
  double centre_of_mass_x = 0, centre_of_mass_y = 0;
  double max_speed = 0, cfl = 0;
  double wall_force_x = 0, wall_force_y = 0;
};

/// Number of arrays in a frame, one of each: x and y from the lower left corner of the domain, vx, vy,
/// density, pressure.
inline constexpr size_t values_per_particle = 6;

}  // namespace sluice::media
