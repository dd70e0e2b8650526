// The plan: which stages run in which phase, for a model and a task. All of it follows from the tables; a
// backend only knows how to run a stage.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/model/stages.hpp"

namespace sluice {

/// Fields that the simulator hands from step to step, whatever the stages are: what a step leaves in the
/// first is in the second when the next begins.
inline constexpr std::array<std::pair<Field, Field>, 3> handed_on{
    {{Field::id, Field::id_in}, {Field::p, Field::p_in}, {Field::rho, Field::rho_in}}};

struct Plan {
  Needs needs;
  std::array<std::vector<Stage>, phase_count> phases;

  const std::vector<Stage>& operator[](Phase phase) const& { return phases[static_cast<uint32_t>(phase)]; }
  std::vector<Stage> operator[](Phase phase) && { return std::move(phases[static_cast<uint32_t>(phase)]); }

  /// Whether pressure comes from sweeps that are repeated until it has converged.
  bool sweeps() const { return !(*this)[Phase::sweep].empty(); }

  /// Everything any planned stage reads or writes: what has to be allocated.
  FieldSet fields() const;
  /// The stages of all phases in order, the sweep's once.
  std::vector<Stage> stages() const;
};

/// The plan of one step, or of one relaxation of the positions: density, then a pressure solve whose
/// acceleration moves particles.
Plan make_plan(const Model& model, Task task = Task::step);

}  // namespace sluice
