// The step, the solver loop, the start and the verdict.
#include "core/solver/simulator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/solver/sorted_boundary.hpp"
#include "core/solver/verdict.hpp"
#include "sluice/error.hpp"

namespace sluice {
namespace {

/// Sweeps between two looks at whether the solve is over. A look makes a GPU wait; sweeps after the end cost
/// it next to nothing.
constexpr uint32_t sweeps_between_looks = 4;
/// Sweeps before the first look: a solve that was cut off says nothing of the next.
constexpr uint32_t most_sweeps_unseen = 64;

std::vector<Vec2> moved(std::vector<Vec2> points, Vec2 by) {
  for (Vec2& point : points) point += by;
  return points;
}

std::span<const double> flat(const std::vector<Vec2>& values) {
  return {reinterpret_cast<const double*>(values.data()), 2 * values.size()};
}
std::span<double> flat(std::vector<Vec2>& values) {
  return {reinterpret_cast<double*>(values.data()), 2 * values.size()};
}

/// Values in the order of ids, `each` of them per particle.
template <class T>
std::vector<T> by_id(const std::vector<T>& values, const std::vector<uint32_t>& ids, size_t each = 1) {
  std::vector<T> sorted(values.size());
  for (size_t i = 0; i < ids.size(); ++i)
    for (size_t k = 0; k < each; ++k) sorted[each * ids[i] + k] = values[each * i + k];
  return sorted;
}

std::optional<size_t> first_not_finite(const std::vector<Vec2>& values) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i].x) || !std::isfinite(values[i].y)) return i;
  }
  return std::nullopt;
}

}  // namespace

Simulator::Simulator(Outliving<Scene> scene, Outliving<Samples> samples, Backend& backend)
    : Simulator(scene, samples, backend, NotStarted{}) {
  const std::vector<Vec2> x = moved(samples_.fluid, -params_.origin);
  start(scene_.relax > 0 ? relaxed_positions(x) : x);
}

Simulator::Simulator(const Scene& scene, const Samples& samples, Backend& backend, NotStarted)
    : scene_(scene),
      samples_(samples),
      backend_(backend),
      params_(make_params(scene, static_cast<uint32_t>(samples.fluid.size()))),
      plan_(make_plan(model_of(scene))) {
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
    v[i] = start_velocity(scene_, samples_, i, params_.origin + x[i]);
  }
  set_up(plan_, params_);
  upload_state(x, v);
  refuse_beyond_range();
  begin_step();
  run(plan_[Phase::sort]);
  List list = List::fits;
  do {
    run(plan_[Phase::search]);
    list = judge_list();
  } while (list == List::longer_now);
  if (list == List::beyond_bounds) {
    throw InputError(
        fmt::format("{}: fluid: found a start with too many particles in one place, expected them about {:g} "
                    "apart; spread them out",
                    scene_.file, scene_.spacing));
  }
  const std::vector<Vec2> sorted_x = vectors(Field::x), sorted_v = vectors(Field::v);
  backend_.upload(Field::x_in, flat(sorted_x));
  backend_.upload(Field::v_in, flat(sorted_v));
  backend_.reset_seconds();
  if (scene_.adaptive) begin_adaptive(x, v);
}

/// What is finite in a scene may not be in float.
void Simulator::refuse_beyond_range() const {
  const double dt = scene_.adaptive ? scene_.adaptive->dt_min : scene_.dt;
  const auto shortest = static_cast<float>(dt), longest = static_cast<float>(scene_.dt);
  if (backend_.precision() == Precision::single_ && !(shortest > 0 && std::isfinite(longest))) {
    throw InputError(
        fmt::format("{}: time: found steps of {:g}, beyond the range of this precision, expected them within "
                    "it; use --precision double or another unit of time",
                    scene_.file, shortest > 0 ? scene_.dt : dt));
  }
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
  const Plan plan = make_plan(model_of(scene_), Task::relaxation);
  set_up(plan, make_relax_params(scene_, params_.n));
  upload_state(x, std::vector<Vec2>(x.size()));
  for (uint32_t round = 0; round < scene_.relax; ++round) {
    StepReport report;
    if (!run_step(plan, report)) {
      throw InputError(
          fmt::format("{}: fluid.relax: found a relaxation that drives particles into one place, expected "
                      "positions that can be relaxed; lower fluid.jitter or leave out fluid.relax",
                      scene_.file));
    }
  }
  std::vector<Vec2> relaxed = by_id(vectors(Field::x_in), ids(Field::id));
  if (const auto i = first_not_finite(relaxed)) {
    throw InputError(
        fmt::format("{}: fluid.relax: found a relaxation that diverges at particle {} near ({:g}, {:g}), "
                    "expected positions that can be relaxed; lower fluid.jitter or leave out fluid.relax",
                    scene_.file, *i, samples_.fluid[*i].x, samples_.fluid[*i].y));
  }
  return relaxed;
}

void Simulator::set_up(const Plan& plan, const Params& params) {
  backend_.allocate(plan.fields(), sizes_);
  backend_.configure(params, plan.needs);
  if (plan.needs.boundary) {
    const SortedBoundary boundary = sort_boundary(samples_.boundary, params);
    backend_.upload(Field::C_boundary, boundary.C);
    backend_.upload(Field::x_boundary, flat(boundary.x));
  }
  run(plan[Phase::once]);
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
  for (const auto& [left, found] : handed_on) backend_.swap(left, found);
}

void Simulator::run(std::span<const Stage> stages) {
  for (const Stage stage : stages) backend_.run(stage);
}

/// All of a step; returns false where no neighbour list would do. Whether the list was long enough is asked
/// once, at the end: if not, it is made longer, and all that follows from it is done again from the sorted
/// state, which integration leaves alone. So is a step that moved a particle too far, with a shorter dt.
bool Simulator::run_step(const Plan& plan, StepReport& report) {
  begin_step();
  run(plan[Phase::sort]);
  List list = List::longer_now;
  do {
    if (list == List::longer_now) run(plan[Phase::search]);
    run(plan[Phase::forces]);
    if (plan.sweeps()) solve_pressure(plan[Phase::sweep], report);
    run(plan[Phase::finish]);
    list = judge_list();
    if (list == List::beyond_bounds) return false;
  } while (list == List::longer_now || moved_too_far(report));
  // Not before the step stands: a solve with a list that was too short means nothing.
  if (plan.sweeps()) first_look_ = std::min(report.iterations, most_sweeps_unseen);
  return true;
}

/// Reads what an adaptive step led to; shortens it if that is too far and there is a shorter one.
bool Simulator::moved_too_far(StepReport& report) {
  if (!control_) return false;
  report.diagnostics = read_diagnostics();
  if (control_->holds(report.diagnostics)) return false;
  const std::optional<double> dt = control_->shorter(params_.dt, report.diagnostics);
  if (!dt) return false;
  change_dt(*dt);
  ++report.repeats;
  return true;
}

/// Makes the neighbour list longer if it is too short.
Simulator::List Simulator::judge_list() {
  uint32_t needed = 0;
  backend_.download(Field::list_needed, std::span(&needed, 1));
  if (needed <= sizes_.list) return List::fits;
  const uint64_t most = std::min<uint64_t>(most_list_growth * first_list_size(sizes_.fluid, scene_.smoothing),
                                           list_beyond_bounds - 1);
  if (needed > most) return List::beyond_bounds;
  sizes_.list = std::min<uint64_t>(uint64_t{needed} + needed / 4, most) / slice_width * slice_width;
  backend_.resize_list(sizes_.list);
  return List::longer_now;
}

/// The IISPH loop [Hunkler 2022, algorithm 6]; when it ends is decided by the stage `stop_test`.
void Simulator::solve_pressure(const std::vector<Stage>& sweep, StepReport& report) {
  std::array<uint32_t, 2> sweeps{};
  backend_.upload(Field::sweeps, sweeps);
  uint32_t times = reports_sweeps_ ? 1 : first_look_;
  uint64_t asked_for = 0;
  report.sweeps.clear();
  do {
    if (asked_for > params_.max_iterations + uint64_t{most_sweeps_unseen}) {
      throw EnvironmentError(
          fmt::format("{} does not compute any more: {} sweeps of step {} were asked for, and it counts {} "
                      "without an end; "
                      "restart its driver, try another device, or use --backend cpu",
                      backend_.device(), asked_for, steps_ + 1, sweeps[0]));
    }
    backend_.sweep(sweep, times);
    backend_.download(Field::sweeps, sweeps);
    asked_for += times;
    if (reports_sweeps_)
      report.sweeps.push_back(last_sweep());
    else
      times = sweeps_between_looks;
  } while (static_cast<Solve>(sweeps[1]) == Solve::unfinished);
  std::array<double, 4> solve{};
  backend_.download(Field::solve, solve);
  report.iterations = sweeps[0];
  report.converged = static_cast<Solve>(sweeps[1]) == Solve::converged;
  report.residual = report.converged || !std::isfinite(solve[1]) ? solve[0] : solve[1];
}

/// From the sums that its stop test had, in double.
SweepReport Simulator::last_sweep() const {
  std::vector<double> sums(sizes_.of(Length::residual));
  backend_.download(Field::residual_sums, sums);
  const auto total = [&](ResidualSum which) {
    const auto chunks = static_cast<std::ptrdiff_t>(sizes_.chunks());
    const auto first = sums.begin() + static_cast<std::ptrdiff_t>(which) * chunks;
    return std::accumulate(first, first + chunks, 0.0);
  };
  const auto quotient = [](double a, double b) { return a == 0 ? 0 : a / b; };
  std::array<double, 4> solve{};
  backend_.download(Field::solve, solve);
  return {quotient(total(ResidualSum::error), params_.rho0 * total(ResidualSum::counted)),
          std::sqrt(quotient(total(ResidualSum::squares), total(ResidualSum::source_squares))), solve[2]};
}

void Simulator::change_dt(double dt) {
  if (dt == params_.dt) return;
  time_before_ = time();
  steps_before_ = steps_;
  params_ = make_params(scene_, params_.n, dt);
  backend_.configure(params_, plan_.needs);
}

StepControl Simulator::make_control() const {
  return {*scene_.adaptive, scene_.spacing, step_bounds(scene_, samples_).safe()};
}

/// The first step follows from the start's speeds and external accelerations.
void Simulator::begin_adaptive(const std::vector<Vec2>& x, const std::vector<Vec2>& v) {
  control_ = make_control();
  double speed = 0, acceleration = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Vec2 a = external_acceleration(scene_, params_.origin + x[i]);
    speed = std::max(speed, std::hypot(v[i].x, v[i].y));
    acceleration = std::max(acceleration, std::hypot(a.x, a.y));
  }
  next_dt_ = control_->longest(speed, acceleration);
}

bool Simulator::is_cut_short(double end) const { return control_ && end - time() < 2 * next_dt_; }

/// The next step of a run that is to end at `end`: the last two share what is left, as one tiny step would
/// ask for huge accelerations.
double Simulator::cut_dt(double end) const {
  constexpr double close = 1 + 1e-6;
  const double left = end - time();
  if (left <= 0) throw std::logic_error("a step of a run that has reached its end");
  if (left <= close * next_dt_) return left;
  return is_cut_short(end) ? left / 2 : next_dt_;
}

Diagnostics Simulator::read_diagnostics() const {
  std::array<double, total_count> totals{};
  backend_.download(Field::totals, totals);
  return make_diagnostics(totals, params_);
}

StepReport Simulator::step(double end) {
  StepReport report;
  if (control_) change_dt(cut_dt(end));
  const bool stands = run_step(plan_, report);
  ++steps_;
  report.step = steps_;
  report.time = time();
  report.dt = params_.dt;
  if (stands && !control_) report.diagnostics = read_diagnostics();
  if (!stands) report.diagnostics = diagnostics_;
  if (stands && report.diagnostics.finite() && report.diagnostics.lost != diagnostics_.lost)
    losses_.note(report, params_, ids(Field::id), vectors(Field::x_in));
  find_failure(report, stands);
  diagnostics_ = report.diagnostics;
  if (control_) next_dt_ = control_->next(params_.dt, diagnostics_);
  return report;
}

void Simulator::find_failure(const StepReport& report, bool stands) {
  const bool holds = !control_ || control_->holds(report.diagnostics);
  if (stands && holds && !is_suspect(report, params_)) return;
  last_state_stands_ = stands;
  const Snapshot after = snapshot();
  if (!stands) {
    failure_ = find_crowd(report, params_, after);
    return;
  }
  last_state_stands_ = is_finite(after);
  failure_ = is_suspect(report, params_) ? sluice::find_failure(report, params_, state_before_step(), after)
                                         : find_runaway(report, params_, scene_.adaptive->cfl, after);
}

std::vector<uint32_t> Simulator::ids(Field field) const {
  std::vector<uint32_t> values(sizes_.fluid);
  backend_.download(field, values);
  for (const uint32_t id : values) {
    if (id >= sizes_.fluid)
      throw EnvironmentError(fmt::format(
          "the device gave back particle {} of {}; its memory or its driver is at fault, try another "
          "one, or --backend cpu",
          id, sizes_.fluid));
  }
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
  if (!last_state_stands_) return state_before_step();
  const std::vector<uint32_t> id = ids(Field::id);
  return {by_id(moved(vectors(Field::x_in), params_.origin), id), by_id(vectors(Field::v_in), id),
          by_id(scalars(Field::rho), id), by_id(scalars(Field::p), id), steps_};
}

/// Most fields are in the order of the last step; these are in that of the one before.
std::vector<double> Simulator::reals(Field field) const {
  constexpr FieldSet of_the_step_before{Field::p_in, Field::rho_in};
  const std::vector<uint32_t> id = ids(of_the_step_before.has(field) ? Field::id_in : Field::id);
  const size_t each = components(info(field).type);
  std::vector<double> values(each * id.size());
  backend_.download(field, values);
  return by_id(values, id, each);
}

/// State before the last step, which is still there: x and v in the order of the last step, rho and p in that
/// of the step before.
Snapshot Simulator::state_before_step() const {
  const std::vector<uint32_t> id = ids(Field::id), id_before = ids(Field::id_in);
  return {by_id(moved(vectors(Field::x), params_.origin), id), by_id(vectors(Field::v), id),
          by_id(scalars(Field::rho_in), id_before), by_id(scalars(Field::p_in), id_before), steps_ - 1};
}

SimulationState Simulator::state() const {
  const std::vector<uint32_t> id = ids(Field::id);
  return {{steps_, steps_before_, time_before_, params_.dt, next_dt_},
          diagnostics_,
          by_id(vectors(Field::x_in), id),
          by_id(vectors(Field::v_in), id),
          by_id(scalars(Field::rho), id),
          by_id(scalars(Field::p), id)};
}

/// Particles stand where the last step left them, in its order. The next adaptive step follows from the new
/// state.
void Simulator::set_state(Field field, std::span<const Vec2> values, Vec2 origin) {
  const std::string what = field == Field::x_in ? "positions" : "velocities";
  if (values.size() != sizes_.fluid) {
    throw InputError(fmt::format("{}: found {} {}, expected those of {} particles", scene_.file,
                                 values.size(), what, sizes_.fluid));
  }
  const std::vector<uint32_t> id = ids(Field::id);
  std::vector<Vec2> sorted(values.size());
  const double largest = backend_.precision() == Precision::single_
                             ? static_cast<double>(std::numeric_limits<float>::max())
                             : std::numeric_limits<double>::max();
  for (size_t i = 0; i < sorted.size(); ++i) {
    sorted[i] = values[id[i]] - origin;
    if (!(std::abs(sorted[i].x) <= largest && std::abs(sorted[i].y) <= largest)) {
      throw InputError(fmt::format("{}: {}: found ({:g}, {:g}) for particle {}, expected finite numbers",
                                   scene_.file, what, values[id[i]].x, values[id[i]].y, id[i]));
    }
  }
  backend_.upload(field, flat(sorted));
  if (scene_.adaptive) begin_adaptive(vectors(Field::x_in), vectors(Field::v_in));
}

void Simulator::set_positions(std::span<const Vec2> x) { set_state(Field::x_in, x, params_.origin); }

void Simulator::set_velocities(std::span<const Vec2> v) { set_state(Field::v_in, v, {}); }

/// What the last step left behind is put where it left it. Particles stand in another order than there; the
/// grid sorts them by cell and id, so that no step sees it.
Simulator::Simulator(Outliving<Scene> scene, Outliving<Samples> samples, Backend& backend,
                     const SimulationState& state)
    : Simulator(scene, samples, backend, NotStarted{}) {
  steps_ = state.clock.steps;
  steps_before_ = state.clock.steps_before;
  time_before_ = state.clock.time_before;
  next_dt_ = state.clock.next_dt;
  diagnostics_ = state.diagnostics;
  if (scene_.adaptive) control_ = make_control();
  params_ = make_params(scene_, params_.n, state.clock.dt);
  set_up(plan_, params_);
  upload_state(state.x, state.v);
  backend_.upload(Field::rho, state.density);
  backend_.upload(Field::p, state.pressure);
  losses_.know(params_, state.x);
  if (scene_.adaptive && steps_ == 0) begin_adaptive(state.x, state.v);
  backend_.reset_seconds();
}

}  // namespace sluice
