// How far drops are off their exact motion.
#pragma once

#include <vector>

#include "studies/blob.hpp"
#include "studies/ideal_drop.hpp"
#include "studies/validation.hpp"

namespace sluice {

inline constexpr IdealDrop oscillating_drop{.radius = 1, .rate = 0.5, .omega_squared = 1};
inline constexpr IdealDrop elliptic_drop{.radius = 1, .rate = -100, .omega_squared = 0};

/// Over two periods, of frames that reach beyond them, several in each quarter of a period:
/// - "semi-axes": the largest error of either, over the radius;
/// - "period": half the time of the fourth change of sign of A - B after the start;
/// - "energy per period": half of what the total energy changes by, over the kinetic energy of the start,
/// which is
///   all the drop has above that of rest.
std::vector<Measure> oscillation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs);

/// "major semi-axis" and "minor semi-axis": the largest error of any frame, over what the axis is then.
std::vector<Measure> elongation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs);

}  // namespace sluice
