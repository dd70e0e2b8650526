// Walks the plan: sets up the start, runs the stages of a step in order, decides when the pressure has
// converged and whether the run is still valid. All policy is here; the backend only computes.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/model/plan.hpp"
#include "core/outliving.hpp"
#include "core/solver/backend.hpp"
#include "core/solver/losses.hpp"
#include "core/solver/simulation_state.hpp"
#include "core/solver/time_step.hpp"
#include "sluice/report.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice {

class Simulator {
 public:
  /// Sets up the start of `scene` on `backend`, which outlives the simulator, relaxed if the scene asks for
  /// it.
  Simulator(Outliving<Scene> scene, Outliving<Samples> samples, Backend& backend);

  /// Goes on from `state`, which state() returned in a run of the same scene and precision: every later step
  /// has the bits that it has there.
  Simulator(Outliving<Scene> scene, Outliving<Samples> samples, Backend& backend,
            const SimulationState& state);

  /// Runs one step. Sets failure() when the state it leads to is invalid; then no further step may follow.
  /// Where the scene's steps adapt, they are shortened to end at the time `end`, which is yet to come, and
  /// one that moves a particle too far is repeated with a shorter dt.
  StepReport step(double end = std::numeric_limits<double>::infinity());

  uint64_t steps() const { return steps_; }
  double time() const { return time_before_ + static_cast<double>(steps_ - steps_before_) * params_.dt; }
  double dt() const { return params_.dt; }
  /// Whether the next step has to be shorter than the fluid would need for a run to end at `end`.
  bool is_cut_short(double end) const;
  /// Sets the time step from now on, above 0; where steps adapt, that of the next step alone.
  void change_dt(double dt);
  const std::optional<Failure>& failure() const { return failure_; }
  const Plan& plan() const { return plan_; }
  const Sizes& sizes() const { return sizes_; }
  /// The particles that left the domain, as far as their number changed when they did.
  const std::vector<Loss>& losses() const { return losses_.all(); }

  /// The state after the last step, or the last finite one before it. At step 0 the density is that of the
  /// start.
  Snapshot snapshot() const;

  /// Numbers of a planned field of reals that has one or several per particle, as the last step left them,
  /// particles in the order of their ids.
  std::vector<double> reals(Field field) const;

  /// State that another simulator can go on from. Only while there is no failure().
  SimulationState state() const;

  /// Has every step report its sweeps from now on. Then each is waited for, which takes a device longer.
  void report_sweeps() { reports_sweeps_ = true; }

  /// Sets the positions, or velocities, that the next step starts from, in the order of ids. InputError when
  /// there are not as many as particles, or when one is not finite in this precision: then nothing changes.
  void set_positions(std::span<const Vec2> x);
  void set_velocities(std::span<const Vec2> v);

 private:
  struct NotStarted {};
  Simulator(const Scene& scene, const Samples& samples, Backend& backend, NotStarted);
  void set_state(Field field, std::span<const Vec2> values, Vec2 origin);
  void start(const std::vector<Vec2>& x);
  void refuse_beyond_range() const;
  std::vector<Vec2> relaxed_positions(const std::vector<Vec2>& x);
  void upload_state(const std::vector<Vec2>& x, const std::vector<Vec2>& v);
  void set_up(const Plan& plan, const Params& params);
  void begin_step();
  void begin_adaptive(const std::vector<Vec2>& x, const std::vector<Vec2>& v);
  StepControl make_control() const;
  double cut_dt(double end) const;
  void run(std::span<const Stage> stages);
  bool run_step(const Plan& plan, StepReport& report);
  bool moved_too_far(StepReport& report);
  Diagnostics read_diagnostics() const;
  void find_failure(const StepReport& report, bool stands);
  enum class List { fits, longer_now, beyond_bounds };
  List judge_list();
  void solve_pressure(const std::vector<Stage>& sweep, StepReport& report);
  SweepReport last_sweep() const;
  Snapshot state_before_step() const;
  std::vector<uint32_t> ids(Field field) const;
  std::vector<double> scalars(Field field) const;
  std::vector<Vec2> vectors(Field field) const;

  const Scene& scene_;
  const Samples& samples_;
  Backend& backend_;
  Params params_;
  Sizes sizes_;
  Plan plan_;
  bool reports_sweeps_ = false;
  uint32_t first_look_ = 1;  ///< sweeps before the solve is looked at: as many as the last one needed
  uint64_t steps_ = 0;
  std::optional<StepControl> control_;  ///< where the steps adapt
  double next_dt_ = 0;                  ///< length of the next step, unless it is cut short
  uint64_t steps_before_ = 0;           ///< steps and time before the last change of dt
  double time_before_ = 0;
  Diagnostics diagnostics_;        ///< what the last step reported
  bool last_state_stands_ = true;  ///< what the last step led to can be shown
  Losses losses_;
  std::optional<Failure> failure_;
};

}  // namespace sluice
