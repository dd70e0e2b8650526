// How far free lumps of fluid are off their exact motion.
#pragma once

#include <string>
#include <vector>

#include "studies/blob.hpp"
#include "studies/ideal_drop.hpp"
#include "studies/validation.hpp"

namespace sluice::study {

inline constexpr IdealDrop oscillating_drop{.radius = 1, .rate = 0.5, .omega_squared = 1};
inline constexpr IdealDrop elliptic_drop{.radius = 1, .rate = -100, .omega_squared = 0};

/// Of frames that begin at t = 0 and reach beyond a period, several in each quarter of it:
/// - "semi-axes after a period": the larger error of the two, over the radius;
/// - "semi-axes, largest error": the largest of either in all frames up to there, over the radius;
/// - "period": the time of the second change of sign of A - B after the start;
/// - "energy per period": what kinetic energy and that of the force together lose in a period, over the
///   kinetic energy of the start: all that the drop has above rest.
std::vector<Measure> oscillation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs);

/// Without Omega: "major semi-axis" and "minor semi-axis", the one that grows and the other: the largest
/// error of any frame, over what the axis is then.
std::vector<Measure> elongation_measures(const IdealDrop& drop, const std::vector<Blob>& blobs);

/// What a lump does as a whole while no force but gravity acts on it, in steps of dt.
struct FreeMotion {
  Vec2 velocity{};  ///< at t = 0
  Vec2 gravity{};
  double dt = 0;
};

/// - "centre of mass": the largest error of any frame against what the steps add up to,
///   x0 + v t + g t (t + dt)/2, over the distance travelled in the end;
/// - "momentum": that of its velocity against v + g t, over the largest speed of the end;
/// - "fall", with gravity: that of the centre's last place against g t²/2: the error of the steps.
std::vector<Measure> motion_measures(const FreeMotion& motion, const std::vector<Blob>& blobs);

/// "angular momentum" about the origin: its largest change, over that of the start.
std::vector<Measure> rotation_measures(const std::vector<Blob>& blobs);

/// What is set of a scene for this method with these steps.
std::vector<std::string> with_method(const char* method, double dt);

std::vector<ValidationCase> motion_cases();

}  // namespace sluice::study
