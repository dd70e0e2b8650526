// `sluice run`: simulates a scene and writes what was asked for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "apps/sluice/checkpoints.hpp"
#include "apps/sluice/clashes.hpp"
#include "apps/sluice/commands.hpp"
#include "apps/sluice/frames.hpp"
#include "apps/sluice/interrupt.hpp"
#include "apps/sluice/machine.hpp"
#include "apps/sluice/progress.hpp"
#include "apps/sluice/warnings.hpp"
#include "core/attempts.hpp"
#include "core/measure/probes.hpp"
#include "core/measure/wall_forces.hpp"
#include "core/output/frame_clock.hpp"
#include "core/output/series.hpp"
#include "core/output/state_file.hpp"
#include "core/output/summary.hpp"
#include "core/solver/memory.hpp"
#include "core/solver/simulator.hpp"
#include "sluice/error.hpp"

namespace sluice::app {
namespace {

constexpr double most_frames = 1e6;  // frame names have six digits

/// End of a run: after so many steps, or at a time.
struct RunEnd {
  uint64_t steps = std::numeric_limits<uint64_t>::max();
  double time = std::numeric_limits<double>::infinity();

  bool reached(const Simulator& simulator) const {
    return simulator.steps() >= steps || simulator.time() >= time;
  }
  bool at_time() const { return std::isfinite(time); }
  /// The time it is reached at, or if steps adapt the latest.
  double latest(double dt) const { return at_time() ? time : static_cast<double>(steps) * dt; }
};

RunEnd end_of(const RunOptions& options, const Scene& scene) {
  if (options.steps) return {.steps = *options.steps};
  const double duration = options.time.value_or(scene.duration);
  if (scene.adaptive) return {.time = duration};
  const double steps = std::round(duration / scene.dt);
  if (steps > 1e15) {
    throw InputError(
        fmt::format("{}: time: found a run of {:.3g} steps, expected at most 1e15; use a shorter time or "
                    "a larger time step",
                    scene.file, steps));
  }
  return {.steps = static_cast<uint64_t>(steps)};
}

/// Refuses a run up to this time that would have too many frames.
void limit_frames(const RunOptions& options, const Scene& scene, double time) {
  const double frames = std::floor((time + FrameClock::slack) * scene.fps) + 1;
  if (!options.frames.any() || frames <= most_frames) return;
  throw InputError(
      fmt::format("{}: output.fps: found {:g}, which makes {:.3g} frames, expected at most {:g}; use a "
                  "lower --fps or a shorter --time",
                  scene.file, scene.fps, frames, most_frames));
}

/// None may be another one or what is read, but that a checkpoint may take the place of the one before it.
void refuse_clashing_places(const RunOptions& options, const Scene& scene) {
  std::vector<NamedFile> files{{"--sweeps", options.sweeps},
                               {"--probes", options.probes},
                               {"--wall-forces", options.wall_forces},
                               {"--start-from", options.start_from},
                               {"--state", options.state},
                               {"--series", options.series},
                               {"--summary", options.summary},
                               {"--record", options.frames.record},
                               {"--video", options.frames.video},
                               {"--frames", options.frames.frames},
                               {"--vtk", options.frames.vtk}};
  if (options.scene) files.insert(files.begin(), {"the scene", scene.file});
  files.insert(files.begin(), {"--resume", options.resume});
  refuse_clashes(files);
  files.front() = {"--checkpoint", options.checkpoint};
  refuse_clashes(files);
}

/// The files of a run. All are opened before the first step, so that a folder that is not there is known at
/// once.
class Outputs {
 public:
  /// Frames that were due before the checkpoint `from` are not made again.
  Outputs(const RunOptions& options, const Scene& scene, const Samples& samples, Machine& machine,
          const std::optional<Checkpoint>& from, const Simulator& simulator)
      : precision_(machine.backend().precision()),
        takes_frames_(options.frames.any()),
        clock_(scene.fps),
        backend_(machine.gpu_backend()) {
    if (options.state) state_.emplace(*options.state);
    if (options.summary) summary_.emplace(*options.summary);
    for (const std::string& name : options.dump)
      dump_.push_back(particle_field("--dump", name, simulator.plan()));
    if (options.series) series_.emplace(*options.series, precision_);
    if (options.sweeps) step_files_.push_back(sweeps_file(*options.sweeps));
    if (options.probes) step_files_.push_back(probes_file(*options.probes, scene, simulator));
    if (options.wall_forces) {
      step_files_.push_back(
          wall_forces_file(*options.wall_forces, scene, samples, machine.backend(), simulator));
    }
    FramesBefore before;
    if (from && takes_frames_) before = {clock_.advance(from->state.clock.time()), from->state.clock.time()};
    frames_.emplace(
        options.frames, scene, samples, precision_, machine.backend().device(),
        [&]() -> const gpu::Context& { return machine.context(); }, before);
  }

  void add(const Simulator& simulator, const StepReport& report, double seconds_per_step) {
    if (series_ && report.step > 0) series_->add(report);
    if (report.step > 0)
      for (StepFile& file : step_files_) file.add(report);
    if (!takes_frames_) return;
    // The buffers hold what a failed step led to, which may not be finite; the snapshot is fit to be shown.
    const StateSource state{[&] { return simulator.snapshot(); }, simulator.failure() ? nullptr : backend_};
    for (uint64_t due = clock_.advance(report.time); due > 0; --due)
      frames_->add(report, seconds_per_step, state);
  }

  /// Returns when what a run that goes on does not make again has been written, if not yet to the disk
  /// itself.
  void flush() { frames_->flush(); }

  /// Saves the rows and frames of a run that is about to fail for another reason, which is the news.
  void save() noexcept {
    Attempts attempt;
    if (series_) attempt([&] { series_->commit(); });
    for (StepFile& file : step_files_) attempt([&] { file.commit(); });
    attempt([&] { frames_->finish(); });
  }

  /// Everything that can be written is, though one fails.
  void finish(const RunSummary& summary, Checkpoints& checkpoints) {
    Attempts attempt;
    attempt([&] { checkpoints.write(summary.simulator, summary.statistics); });
    if (series_) attempt([&] { series_->commit(); });
    for (StepFile& file : step_files_) attempt([&] { file.commit(); });
    if (state_) attempt([&] { write_last_state(summary.simulator); });
    if (summary_) attempt([&] { write_summary(summary); });
    attempt([&] { frames_->finish(); });
    attempt.end();
  }

  void tell_of_frames(bool quiet) const { frames_->tell(quiet); }

 private:
  void write_last_state(const Simulator& simulator) {
    std::vector<StateColumns> more;
    for (const Field field : dump_) more.push_back(columns_of(field, simulator));
    write_state(*state_, simulator.snapshot(), precision_, more);
  }

  void write_summary(const RunSummary& summary) {
    summary_->write(to_json(summary).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
    summary_->commit();
  }

  Precision precision_;
  bool takes_frames_;
  FrameClock clock_;
  const gpu::GpuBackend* backend_;
  std::optional<OutputFile> state_, summary_;
  std::vector<Field> dump_;
  std::optional<SeriesFile> series_;
  std::vector<StepFile> step_files_;
  std::optional<FrameOutputs> frames_;
};

void add_start(const Simulator& simulator, Outputs& outputs) {
  StepReport start;
  start.dt = simulator.dt();
  outputs.add(simulator, start, 0);
}

void simulate(Simulator& simulator, const RunEnd& end, Outputs& outputs, Checkpoints& checkpoints,
              Progress& progress, RunStatistics& statistics, Stopwatch& watch) {
  const auto save = [&] {
    outputs.flush();
    checkpoints.write(simulator, statistics);
  };
  while (!end.reached(simulator) && !simulator.failure() && !interrupted()) {
    // The last steps of a run that ends at a time are shorter than those of one that goes on.
    if (checkpoints.wanted() && simulator.is_cut_short(end.time)) {
      save();
      checkpoints.hold();
    }
    watch.start();
    const StepReport report = simulator.step(end.time);
    const double step_seconds = watch.stop();
    statistics.add(report);
    outputs.add(simulator, report, step_seconds);
    if (checkpoints.due(report.time)) save();
    progress.show(report.step, report, statistics.not_converged());
  }
}

int report_end(const RunSummary& summary, const RunEnd& end, bool quiet) {
  if (!quiet) fmt::print("{}", to_text(summary));
  if (const auto& failure = summary.simulator.failure()) {
    fmt::print(stderr, "sluice: invalid run: {}\n",
               failure_text(summary.scene, summary.statistics, *failure));
    warn_of_losses(summary.statistics, summary.simulator.losses(), quiet);
    return 1;
  }
  warn_of_poor_run(summary.scene, summary.statistics, summary.simulator.losses(), quiet);
  if (interrupted()) {
    const std::string where = end.at_time()
                                  ? fmt::format("at time {:g} of {:g}", summary.simulator.time(), end.time)
                                  : fmt::format("after step {} of {}", summary.simulator.steps(), end.steps);
    fmt::print(stderr, "sluice: interrupted {}; what was asked for is written up to there\n", where);
  }
  return 0;
}

}  // namespace

int run_command(const RunOptions& options) {
  std::optional<Checkpoint> from = checkpoint_to_resume(options);
  std::optional<Checkpoint> start;
  if (options.start_from) start = read_checkpoint(*options.start_from);
  const Scene scene = scene_to_run(options, from, start);
  const RunEnd end = end_of(options, scene);
  limit_frames(options, scene, std::max(end.latest(scene.dt), from ? from->state.clock.time() : 0));
  refuse_clashing_places(options, scene);
  require_memory(scene, options.machine.precision, available_memory(), memory_factor(options.machine));
  const Samples samples = sample(scene);
  MachineOptions machine_options = options.machine;
  machine_options.time_stages = !options.quiet || options.summary;
  Machine machine(machine_options, samples.fluid.size());
  if (options.machine.backend != BackendChoice::cpu && !options.quiet)
    fmt::print(stderr, "backend: {}\n", machine.choice());
  if (!machine.gpu_backend() && !options.frames.pictures())
    warn_of_unused_opengl(options.machine, options.quiet);
  if (!options.frames.video && options.frames.speed != 1)
    warn(options.quiet, "--speed has no effect without --video");
  for (const std::string& limit : beyond_limits(scene, samples)) warn(options.quiet, limit);

  // May refuse the scene: then nothing is written.
  Simulator simulator = make_simulator(options, scene, samples, machine.backend(), from, start);
  if (from) from->state = {from->state.clock, {}, {}, {}, {}, {}};  // the rest is in the backend now
  if (from && end.reached(simulator)) {
    warn(options.quiet,
         fmt::format("the checkpoint is of step {}, time {:g}, where this run ends or later; for "
                     "more steps use a larger --time or --steps",
                     simulator.steps(), simulator.time()));
  }
  note_interrupts();  // from here on there is something to finish
  if (options.sweeps) simulator.report_sweeps();
  Outputs outputs(options, scene, samples, machine, from, simulator);
  Checkpoints checkpoints(options, scene, machine.backend(), simulator.time());
  RunStatistics statistics(from ? from->counts : RunCounts());
  Stopwatch watch;
  const RunSummary summary{scene,
                           samples,
                           machine.backend(),
                           simulator,
                           statistics,
                           watch,
                           options.start_from ? options.start_from->string() : ""};
  {
    Progress progress(end.at_time() ? 0 : end.steps, end.latest(scene.dt), "steps", options.quiet,
                      simulator.steps(), simulator.time());
    try {
      if (!from) add_start(simulator, outputs);
      simulate(simulator, end, outputs, checkpoints, progress, statistics, watch);
    } catch (const Error&) {
      outputs.save();
      throw;
    }
  }
  outputs.finish(summary, checkpoints);
  const int code = report_end(summary, end, options.quiet);
  if (simulator.failure()) checkpoints.tell_of_last();
  outputs.tell_of_frames(options.quiet);
  return code;
}

}  // namespace sluice::app
