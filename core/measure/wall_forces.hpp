// Force and torque of the fluid's pressure on every boundary shape.
#pragma once

#include "core/output/step_file.hpp"
#include "core/solver/simulator.hpp"
#include "core/solver/sorted_boundary.hpp"

namespace sluice {

/// The name of a boundary shape, or its place in the file: "container.0".
std::string name_of(const BoundaryShape& shape);

/// Forces on the scene's boundary shapes, in its order, in the step that a simulator made last: for each
/// sample what it adds to the pressure acceleration, as in the stage `diagnostics`, which has the sum over
/// all.
class WallForces {
 public:
  WallForces(const Scene& scene, const Samples& samples);
  std::vector<WallForce> in(const Backend& backend, const Sizes& sizes) const;

 private:
  Params params_;
  bool pseudo_mass_;
  size_t shapes_;
  SortedBoundary boundary_;
  std::vector<uint32_t> shape_;  ///< of each sorted sample
};

/// A row per step: step, time, and NAME.fx, NAME.fy, NAME.torque of each shape. InputError when the scene has
/// no boundary.
StepFile wall_forces_file(const std::filesystem::path& path, Outliving<Scene> scene,
                          Outliving<Samples> samples, Outliving<Backend> backend,
                          Outliving<Simulator> simulator);

}  // namespace sluice
