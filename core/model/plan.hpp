// The plan: which stages a scene's step runs, in order. Policy lives here and in the simulator; a backend
// only knows how to run a stage.
#pragma once

#include <vector>

#include "core/model/stages.hpp"

namespace sluice {

/// What is computed once, before the first step; and one step: search and density, forces up to the pressure
/// system, the sweep that is repeated until the pressure has converged (empty when pressure comes from a
/// state equation), and what follows.
struct Plan {
  Needs needs;
  std::vector<Stage> once, search, forces, sweep, finish;

  /// All fields any planned stage reads or writes: what has to be allocated.
  FieldSet fields() const;
  /// All stages in order, the sweep once.
  std::vector<Stage> stages() const;
};

/// The plan of one simulation step.
Plan make_plan(const Needs& needs);

/// The plan of one relaxation of the positions: density, then a pressure solve whose acceleration moves
/// particles.
Plan make_relax_plan(const Needs& needs);

}  // namespace sluice
