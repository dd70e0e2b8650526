// The step, the solver loop, the start and the verdict.
#include "core/simulator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/verdict.hpp"

namespace sluice {
namespace {

/// Sweeps between two looks at whether the solve is over. A look makes a GPU wait; sweeps after the end cost
/// it next to nothing.
constexpr uint32_t sweeps_between_looks = 4;
/// Sweeps before the first look: a solve that was cut off says nothing of the next.
constexpr uint32_t most_sweeps_unseen = 64;

/// Boundary samples sorted by grid cell, and the first of each cell.
struct SortedBoundary {
  std::vector<uint32_t> C;
  std::vector<Vec2> x;
};

SortedBoundary sort_boundary(const std::vector<Vec2>& boundary, const Params& params, uint64_t cells) {
  SortedBoundary sorted;
  sorted.C.assign(cells + 1, 0);
  sorted.x.resize(boundary.size());
  for (const Vec2 x : boundary) ++sorted.C[cell_of(params, x) + 1];
  std::partial_sum(sorted.C.begin(), sorted.C.end(), sorted.C.begin());
  std::vector<uint32_t> next = sorted.C;
  for (const Vec2 x : boundary) sorted.x[next[cell_of(params, x)]++] = x;
  return sorted;
}

std::span<const double> flat(const std::vector<Vec2>& values) {
  return {reinterpret_cast<const double*>(values.data()), 2 * values.size()};
}
std::span<double> flat(std::vector<Vec2>& values) {
  return {reinterpret_cast<double*>(values.data()), 2 * values.size()};
}

template <class T>
std::vector<T> by_id(const std::vector<T>& values, const std::vector<uint32_t>& ids) {
  std::vector<T> sorted(values.size());
  for (size_t i = 0; i < values.size(); ++i) sorted[ids[i]] = values[i];
  return sorted;
}

std::optional<size_t> first_not_finite(const std::vector<Vec2>& values) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i].x) || !std::isfinite(values[i].y)) return i;
  }
  return std::nullopt;
}

}  // namespace

Simulator::Simulator(const Scene& scene, const Samples& samples, Backend& backend)
    : Simulator(scene, samples, backend, NotStarted{}) {
  start(scene.relax > 0 ? relaxed_positions(samples.fluid) : samples.fluid);
}

Simulator::Simulator(const Scene& scene, const Samples& samples, Backend& backend, NotStarted)
    : scene_(scene),
      samples_(samples),
      backend_(backend),
      params_(make_params(scene, static_cast<uint32_t>(samples.fluid.size()))),
      plan_(make_plan(needs_of(scene))) {
  sizes_.fluid = samples.fluid.size();
  sizes_.boundary = samples.boundary.size();
  sizes_.cells = uint64_t{params_.columns} * params_.rows;
  sizes_.list = first_list_size(sizes_.fluid, scene.smoothing);
}

/// Velocities come from the (relaxed) positions. The density of the start is computed, so that it can be
/// drawn.
void Simulator::start(const std::vector<Vec2>& x) {
  std::vector<Vec2> v(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    v[i] = start_velocity(scene_.fluid[samples_.fluid_shape[i]], scene_.spacing, x[i]);
  }
  set_up(plan_, params_);
  upload_state(x, v);
  refuse_beyond_range();
  begin_step();
  do {
    run(plan_.search);
  } while (list_was_too_short());
  const std::vector<Vec2> sorted_x = vectors(Field::x), sorted_v = vectors(Field::v);
  backend_.upload(Field::x_in, flat(sorted_x));
  backend_.upload(Field::v_in, flat(sorted_v));
  backend_.reset_seconds();
}

/// What is finite in a scene may not be in float.
void Simulator::refuse_beyond_range() const {
  for (const Field field : {Field::x_in, Field::v_in}) {
    const auto i = first_not_finite(vectors(field));
    if (!i) continue;
    const FluidShape& shape = scene_.fluid[samples_.fluid_shape[*i]];
    throw InputError(
        fmt::format("{}: {}: found a particle whose {} is beyond the range of this precision, expected "
                    "one within it; use --precision double or smaller numbers",
                    shape.where, shape.key, field == Field::x_in ? "position" : "velocity"));
  }
}

std::vector<Vec2> Simulator::relaxed_positions(const std::vector<Vec2>& x) {
  const Plan plan = make_relax_plan(plan_.needs);
  set_up(plan, make_relax_params(params_, scene_));
  upload_state(x, std::vector<Vec2>(x.size()));
  for (uint32_t round = 0; round < scene_.relax; ++round) {
    StepReport report;
    run_step(plan, report);
  }
  std::vector<Vec2> relaxed = by_id(vectors(Field::x_in), ids(Field::id));
  if (const auto i = first_not_finite(relaxed)) {
    throw InputError(
        fmt::format("{}: fluid.relax: found a relaxation that diverges at particle {} near ({:g}, {:g}), "
                    "expected positions that can be relaxed; lower fluid.jitter or leave out fluid.relax",
                    scene_.file, *i, x[*i].x, x[*i].y));
  }
  return relaxed;
}

void Simulator::set_up(const Plan& plan, const Params& params) {
  backend_.allocate(plan.fields(), sizes_);
  backend_.configure(params, plan.needs);
  if (plan.needs.boundary) {
    const SortedBoundary boundary = sort_boundary(samples_.boundary, params, sizes_.cells);
    backend_.upload(Field::C_boundary, boundary.C);
    backend_.upload(Field::x_boundary, flat(boundary.x));
  }
  run(plan.once);
}

/// Fields are zero after allocation, pressure and density too.
void Simulator::upload_state(const std::vector<Vec2>& x, const std::vector<Vec2>& v) {
  std::vector<uint32_t> id(x.size());
  std::iota(id.begin(), id.end(), 0u);
  backend_.upload(Field::id, id);
  backend_.upload(Field::x_in, flat(x));
  backend_.upload(Field::v_in, flat(v));
}

/// What the last step computed becomes what this one starts from; x_in and v_in are there already.
void Simulator::begin_step() {
  backend_.swap(Field::id, Field::id_in);
  backend_.swap(Field::p, Field::p_in);
  backend_.swap(Field::rho, Field::rho_in);
}

void Simulator::run(std::span<const Stage> stages) {
  for (const Stage stage : stages) backend_.run(stage);
}

/// All of a step. Whether the neighbour list was long enough is asked once, at the end: if not, it is made
/// longer, and all that follows from it is done again from the sorted state, which integration leaves alone.
void Simulator::run_step(const Plan& plan, StepReport& report) {
  begin_step();
  const auto neighbours = std::find(plan.search.begin(), plan.search.end(), Stage::neighbours);
  run({plan.search.begin(), neighbours});
  do {
    run({neighbours, plan.search.end()});
    run(plan.forces);
    solve_pressure(plan, report);
    run(plan.finish);
  } while (list_was_too_short());
  // Not before the step stands: a solve with a list that was too short means nothing.
  if (!plan.sweep.empty()) first_look_ = std::min(report.iterations, most_sweeps_unseen);
}

/// Makes the neighbour list longer if it is too short.
bool Simulator::list_was_too_short() {
  uint32_t needed = 0;
  backend_.download(Field::list_needed, std::span(&needed, 1));
  if (needed <= sizes_.list) return false;
  if (needed == list_beyond_bounds) {
    throw EnvironmentError(
        fmt::format("step {}: the neighbour list would need more than 2^32 entries, or on the GPU more than "
                    "{} particles crowd "
                    "around one; use a smaller time step or fewer particles",
                    steps_, most_rounds));
  }
  sizes_.list =
      std::min<uint64_t>(uint64_t{needed} + needed / 4, list_beyond_bounds - 1) / slice_width * slice_width;
  backend_.resize_list(sizes_.list);
  return true;
}

/// The IISPH loop [Hunkler 2022, algorithm 6]; when it ends is decided by the stage `stop_test`.
void Simulator::solve_pressure(const Plan& plan, StepReport& report) {
  if (plan.sweep.empty()) return;
  std::array<uint32_t, 2> sweeps{};
  backend_.upload(Field::sweeps, sweeps);
  uint32_t times = first_look_;
  do {
    backend_.sweep(plan.sweep, times);
    backend_.download(Field::sweeps, sweeps);
    times = sweeps_between_looks;
  } while (static_cast<Solve>(sweeps[1]) == Solve::unfinished);
  std::array<double, 4> solve{};
  backend_.download(Field::solve, solve);
  report.iterations = sweeps[0];
  report.converged = static_cast<Solve>(sweeps[1]) == Solve::converged;
  report.residual = report.converged || !std::isfinite(solve[1]) ? solve[0] : solve[1];
}

void Simulator::change_dt(double dt) {
  time_before_ = time();
  steps_before_ = steps_;
  Scene changed = scene_;
  changed.dt = dt;
  params_ = make_params(changed, params_.n);
  backend_.configure(params_, plan_.needs);
}

StepReport Simulator::step() {
  StepReport report;
  report.step = ++steps_;
  report.time = time();
  report.dt = params_.dt;
  run_step(plan_, report);
  std::array<double, total_count> totals{};
  backend_.download(Field::totals, totals);
  report.diagnostics = make_diagnostics(totals, params_);
  if (is_suspect(report, params_)) {
    const Snapshot after = snapshot();
    last_state_finite_ = is_finite(after);
    failure_ = find_failure(report, params_, state_before_step(), after);
  }
  return report;
}

std::vector<uint32_t> Simulator::ids(Field field) const {
  std::vector<uint32_t> values(sizes_.fluid);
  backend_.download(field, values);
  return values;
}

std::vector<double> Simulator::scalars(Field field) const {
  std::vector<double> values(sizes_.fluid);
  backend_.download(field, values);
  return values;
}

std::vector<Vec2> Simulator::vectors(Field field) const {
  std::vector<Vec2> values(sizes_.fluid);
  backend_.download(field, flat(values));
  return values;
}

Snapshot Simulator::snapshot() const {
  if (!last_state_finite_) return state_before_step();
  const std::vector<uint32_t> id = ids(Field::id);
  return {by_id(vectors(Field::x_in), id), by_id(vectors(Field::v_in), id), by_id(scalars(Field::rho), id),
          by_id(scalars(Field::p), id), steps_};
}

/// It is still there: x and v in the order of the last step, rho and p in that of the step before.
Snapshot Simulator::state_before_step() const {
  const std::vector<uint32_t> id = ids(Field::id), id_before = ids(Field::id_in);
  return {by_id(vectors(Field::x), id), by_id(vectors(Field::v), id),
          by_id(scalars(Field::rho_in), id_before), by_id(scalars(Field::p_in), id_before), steps_ - 1};
}

SimulationState Simulator::state() const {
  const std::vector<uint32_t> id = ids(Field::id);
  return {{steps_, steps_before_, time_before_, params_.dt, time()},
          by_id(vectors(Field::x_in), id),
          by_id(vectors(Field::v_in), id),
          by_id(scalars(Field::rho), id),
          by_id(scalars(Field::p), id)};
}

/// What the last step left behind is put where it left it. Particles stand in another order than there; the
/// grid sorts them by cell and id, so that no step sees it.
Simulator::Simulator(const Scene& scene, const Samples& samples, Backend& backend,
                     const SimulationState& state)
    : Simulator(scene, samples, backend, NotStarted{}) {
  steps_ = state.clock.steps;
  steps_before_ = state.clock.steps_before;
  time_before_ = state.clock.time_before;
  Scene changed = scene;
  changed.dt = state.clock.dt;
  params_ = make_params(changed, params_.n);
  set_up(plan_, params_);
  upload_state(state.x, state.v);
  backend_.upload(Field::rho, state.density);
  backend_.upload(Field::p, state.pressure);
  backend_.reset_seconds();
}

}  // namespace sluice
