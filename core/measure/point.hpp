// What the fluid is like at a point between its particles.
#pragma once

#include <optional>
#include <vector>

#include "sluice/report.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Values at `at`, from the particles within 2H: of the linear function that fits theirs best by least
/// squares weighted with the kernel, which is exact for a linear field also beside a wall or the surface;
/// where they are too few for one or all on a line, sum V_j W f_j / sum V_j W. Cf. the moving least squares
/// of [Dilts 1999] and the normalisation of [Shepard 1968].
PointValues values_at(const Scene& scene, const Snapshot& state, Vec2 at);

/// The fluid's share of the plane, sum V_j W, at a point: 1 inside, 1/2 at a smooth surface.
double share_at(const Scene& scene, const Snapshot& state, Vec2 at);

/// Height of the surface above the point x of the lower edge of the domain: the largest y at (x, y) where the
/// fluid's share is a half. A particle that flies alone has less. None where there is no fluid.
std::optional<double> level_at(const Scene& scene, const Snapshot& state, double x);
/// Front of the fluid at the height y: the largest x at (x, y) where its share is a half.
std::optional<double> front_at(const Scene& scene, const Snapshot& state, double y);

}  // namespace sluice
