// Puts the needed stages in order.
#include "core/model/plan.hpp"

namespace sluice {
namespace {

using enum Stage;

std::vector<Stage> needed(const Needs& needs, std::initializer_list<Stage> stages) {
  std::vector<Stage> kept;
  for (const Stage stage : stages) {
    if (info(stage).needed(needs)) kept.push_back(stage);
  }
  return kept;
}

Plan plan_with(const Needs& needs, std::initializer_list<Stage> finish) {
  Plan plan;
  plan.needs = needs;
  plan.once = needed(needs, {pseudo_mass});
  plan.search = needed(needs, {grid_count, grid_scan, grid_scatter, grid_order, reorder, neighbours, boundary,
                               density, clamp_density});
  plan.forces =
      needed(needs, {external, viscosity, xsph, predict, state_equation, tait, diagonal, source, warm_start});
  if (needs.linear_system) {
    plan.sweep = {pressure_acceleration, pressure_operator, residual, stop_test, pressure_update};
  }
  plan.finish = needed(needs, finish);
  return plan;
}

}  // namespace

FieldSet Plan::fields() const {
  // What the simulator itself hands from step to step, whatever the stages are.
  FieldSet all{Field::id_in, Field::id, Field::p_in, Field::p, Field::rho_in, Field::rho};
  for (const Stage stage : stages()) all = all | reads_of(stage, needs) | writes_of(stage, needs);
  return all;
}

std::vector<Stage> Plan::stages() const {
  std::vector<Stage> all = once;
  for (const auto* part : {&search, &forces, &sweep, &finish})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

Plan make_plan(const Needs& needs) {
  return plan_with(needs, {pressure, pressure_acceleration, integrate, diagnostics, totals});
}

Plan make_relax_plan(const Needs& needs) {
  Needs relaxing = needs;
  relaxing.laplacian = false;
  relaxing.xsph = false;
  relaxing.state_equation = false;
  relaxing.tait = false;
  relaxing.linear_system = true;
  relaxing.relaxation = true;
  return plan_with(relaxing, {pressure, pressure_acceleration, relax});
}

}  // namespace sluice
