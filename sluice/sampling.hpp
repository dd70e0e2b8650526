// Shapes of a scene -> particles and boundary samples.
#pragma once

#include <cstdint>
#include <vector>

#include "sluice/scene.hpp"

namespace sluice {

/// Positions in id order: shapes in file order, within a shape rows outer (y) and columns inner (x).
struct Samples {
  std::vector<Vec2> fluid;
  std::vector<uint32_t> fluid_shape;  ///< index into scene.fluid of each particle
  std::vector<Vec2>
      fluid_velocity;  ///< of each particle at the start, beside its shape's; empty if none has one
  std::vector<Vec2> boundary;
  std::vector<uint32_t> boundary_shape;  ///< index into scene.boundary of each sample
  uint64_t boundary_dropped = 0;  ///< boundary samples left out because they lay within h/2 of an earlier one
};

/// Samples all shapes, checks that no fluid lies within h/2 of a boundary sample or of other fluid, and
/// applies fluid.jitter. Throws InputError naming both places, or when no fluid comes out.
Samples sample(const Scene& scene);

/// Upper bounds on the particles and boundary samples of a scene, found without sampling it.
struct SampleBounds {
  double fluid = 0, boundary = 0;
};
SampleBounds sample_bounds(const Scene& scene);

/// Velocity at the start of the particle at `x` of the given shape: velocity + G (x - centre). The centre is
/// a disc's centre, the middle of a rect's lattice, a polygon's centre of area.
Vec2 start_velocity(const FluidShape& shape, double spacing, Vec2 x);

/// Velocity at the start of particle `i`, which is at `x`: that, and its own where a file gives it one.
Vec2 start_velocity(const Scene& scene, const Samples& samples, size_t i, Vec2 x);

}  // namespace sluice
