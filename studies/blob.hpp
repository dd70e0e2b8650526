// What a free lump of fluid is as a whole: place, momentum, shape, energy.
#pragma once

#include <filesystem>
#include <vector>

#include "sluice/report.hpp"

namespace sluice::study {

/// Means over the particles, which all have the same mass; speeds and energies in the units of the scene, per
/// unit of mass.
struct Blob {
  double time = 0;
  Vec2 centre{};    ///< of mass
  Vec2 velocity{};  ///< of the centre
  /// Along x and y, of the ellipse that has these second moments: those of a full ellipse are a²/4 and b²/4.
  Vec2 semi_axes{};
  double kinetic = 0;           ///< mean of v²/2
  double distance_squared = 0;  ///< mean of |x|² from the origin
  double angular_momentum = 0;  ///< about the origin
};

/// Of one particle or more.
Blob blob_of(double time, const Snapshot& state);

/// Of a recording: the start and every step of which there is a frame, once.
std::vector<Blob> blobs_of(const std::filesystem::path& recording);

/// The value at `time`, and the time at which the value is 0 between frames `i` and `i + 1`, where it changes
/// its sign. By the cubic polynomial through four frames around, of four or more with different times.
double value_at(double time, const std::vector<double>& times, const std::vector<double>& values);
double zero_after(size_t i, const std::vector<double>& times, const std::vector<double>& values);

}  // namespace sluice::study
