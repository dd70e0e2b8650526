// Walks the plan: sets up the start, runs the stages of a step in order, decides when the pressure has
// converged and whether the run is still valid. All policy is here; the backend only computes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/backend.hpp"
#include "core/diagnostics.hpp"
#include "core/plan.hpp"
#include "core/sampling.hpp"
#include "core/scene.hpp"

namespace sluice {

struct StepReport {
  uint64_t step = 0;  ///< 1 for the first
  double time = 0;    ///< at the end of the step
  double dt = 0;
  uint32_t iterations = 0;  ///< 0 where pressure comes from a state equation
  double residual = 0;      ///< the last e
  bool converged = true;
  Diagnostics diagnostics;
};

/// Why a run is invalid, where and when.
struct Failure {
  uint64_t step = 0;
  double time = 0;
  uint32_t id = 0;
  Vec2 x{};  ///< last finite position of that particle
  std::string reason;
};

/// The fluid in id order.
struct Snapshot {
  std::vector<Vec2> x, v;
  std::vector<double> density, pressure;  ///< computed during the step that led to this state
};

class Simulator {
 public:
  /// Sets up the start of `scene` on `backend`, relaxed if the scene asks for it. Both must outlive the
  /// simulator.
  Simulator(const Scene& scene, const Samples& samples, Backend& backend);

  /// Runs one step. Sets failure() when the state it leads to is invalid; then no further step may follow.
  StepReport step();

  uint64_t steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * scene_.dt; }
  double dt() const { return scene_.dt; }
  const std::optional<Failure>& failure() const { return failure_; }
  const Plan& plan() const { return plan_; }

  /// The state after the last step, or the last finite one before it. At step 0 the density is that of the
  /// start.
  Snapshot snapshot() const;

 private:
  void start(const std::vector<Vec2>& x);
  std::vector<Vec2> relaxed_positions(const std::vector<Vec2>& x);
  void upload_state(const std::vector<Vec2>& x, const std::vector<Vec2>& v);
  void allocate(const Plan& plan);
  void begin_step();
  void run(const std::vector<Stage>& stages);
  void run_search(const Plan& plan);
  void solve_pressure(const Plan& plan, double tolerance, StepReport& report);
  std::optional<Failure> judge(const StepReport& report) const;
  std::vector<uint32_t> ids(Field field) const;
  std::vector<double> scalars(Field field) const;
  std::vector<Vec2> vectors(Field field) const;

  const Scene& scene_;
  const Samples& samples_;
  Backend& backend_;
  Params params_;
  Sizes sizes_;
  Plan plan_;
  uint64_t steps_ = 0;
  bool last_state_finite_ = true;
  std::optional<Failure> failure_;
};

}  // namespace sluice
