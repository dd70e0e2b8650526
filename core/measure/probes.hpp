// The probes of a scene, as a file with a row per step.
#pragma once

#include "core/output/step_file.hpp"
#include "core/solver/simulator.hpp"

namespace sluice {

/// The columns of a scene's probes after step and time: NAME.pressure, NAME.density, NAME.vx, NAME.vy of a
/// point, NAME.level of a vertical line and NAME.front of a horizontal one.
std::vector<std::string> probe_columns(const Scene& scene);
/// Their values, in this order; none where a line meets no fluid.
std::vector<std::optional<double>> probe_values(const Scene& scene, const Snapshot& state);

/// A row per step; empty where a line meets no fluid. Scene and simulator outlive it. InputError when the
/// scene has no probes.
StepFile probes_file(const std::filesystem::path& path, Outliving<Scene> scene,
                     Outliving<Simulator> simulator);

}  // namespace sluice
