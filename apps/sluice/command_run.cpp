// `sluice run`: simulates a scene and writes what was asked for.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "apps/sluice/commands.hpp"
#include "apps/sluice/frames.hpp"
#include "apps/sluice/interrupt.hpp"
#include "apps/sluice/machine.hpp"
#include "apps/sluice/progress.hpp"
#include "apps/sluice/warnings.hpp"
#include "core/error.hpp"
#include "core/frame_clock.hpp"
#include "core/memory.hpp"
#include "core/scene_file.hpp"
#include "core/series.hpp"
#include "core/simulator.hpp"
#include "core/state_file.hpp"
#include "core/summary.hpp"

namespace sluice {
namespace {

using Clock = std::chrono::steady_clock;
/// What a software OpenGL takes, in multiples of the fields.
constexpr double gpu_memory = 1.5;
constexpr double most_frames = 1e6;  // frame names have six digits

uint64_t step_count(const RunOptions& options, const Scene& scene) {
  if (options.steps) return *options.steps;
  const double duration = options.time.value_or(scene.duration);
  const double steps = std::round(duration / scene.dt);
  if (steps > 1e15) {
    throw InputError(
        fmt::format("{}: time: found a run of {:.3g} steps, expected at most 1e15; use a shorter time or "
                    "a larger time step",
                    scene.file, steps));
  }
  return static_cast<uint64_t>(steps);
}

void limit_frames(const RunOptions& options, const Scene& scene, uint64_t steps) {
  const double frames = static_cast<double>(steps) * scene.dt * scene.fps;
  const auto& [pictures, video, vtk, record, overlay, speed] = options.frames;
  if (!(pictures || video || vtk || record) || frames <= most_frames) return;
  throw InputError(
      fmt::format("{}: output.fps: found {:g}, which makes {:.3g} frames, expected at most {:g}; use a "
                  "lower --fps or a shorter --time",
                  scene.file, scene.fps, frames, most_frames));
}

/// A file may be written once, and not over the scene.
void refuse_clashes(const RunOptions& options, const Scene& scene) {
  std::map<std::filesystem::path, std::string> taken;
  const auto take = [&](const std::filesystem::path& path, const std::string& what) {
    std::error_code error;
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
      return;  // /dev/stdout
    const auto [other, fresh] = taken.try_emplace(std::filesystem::weakly_canonical(path, error), what);
    if (fresh) return;
    throw InputError(fmt::format("{}: found {}, which is {} too, expected a file of its own", what,
                                 path.string(), other->second));
  };
  take(scene.file, "the scene");
  if (options.state) take(*options.state, "--state");
  if (options.series) take(*options.series, "--series");
  if (options.summary) take(*options.summary, "--summary");
  if (options.frames.record) take(*options.frames.record, "--record");
  if (options.frames.video) take(*options.frames.video, "--video");
}

/// The files of a run. All are opened before the first step, so that a folder that is not there is known at
/// once.
class Outputs {
 public:
  Outputs(const RunOptions& options, const Scene& scene, const Samples& samples, Machine& machine)
      : precision_(machine.backend().precision()), clock_(scene.fps), backend_(machine.gpu_backend()) {
    if (options.state) state_.emplace(*options.state);
    if (options.summary) summary_.emplace(*options.summary);
    if (options.series) series_.emplace(*options.series, precision_);
    frames_.emplace(options.frames, scene, samples, precision_, machine.backend().device(),
                    [&]() -> const gpu::Context& { return machine.context(); });
  }

  void add(const Simulator& simulator, const StepReport& report, double seconds_per_step) {
    if (series_ && report.step > 0) series_->add(report);
    // The buffers hold what a failed step led to, which may not be finite; the snapshot is fit to be shown.
    const StateSource state{[&] { return simulator.snapshot(); }, simulator.failure() ? nullptr : backend_};
    for (uint64_t due = clock_.advance(report.time); due > 0; --due)
      frames_->add(report, seconds_per_step, state);
  }

  /// Saves the rows and frames of a run that is about to fail for another reason; if this fails too, that
  /// reason is the news.
  void save() noexcept {
    try {
      if (series_) series_->commit();
    } catch (const Error&) {
    }
    frames_->save();
  }

  void finish(const RunSummary& summary) {
    if (series_) series_->commit();
    if (state_) write_state(*state_, summary.simulator.snapshot(), precision_);
    if (summary_) {
      summary_->write(to_json(summary).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
      summary_->commit();
    }
    frames_->finish();
  }

  void tell_of_frames(bool quiet) const { frames_->tell(quiet); }

 private:
  Precision precision_;
  FrameClock clock_;
  const gpu::GpuBackend* backend_;
  std::optional<OutputFile> state_, summary_;
  std::optional<SeriesFile> series_;
  std::optional<FrameOutputs> frames_;
};

void simulate(Simulator& simulator, uint64_t steps, Outputs& outputs, Progress& progress,
              RunStatistics& statistics, double& seconds) {
  StepReport start;
  start.dt = simulator.dt();
  outputs.add(simulator, start, 0);
  while (simulator.steps() < steps && !simulator.failure() && !interrupted()) {
    const Clock::time_point before = Clock::now();
    const StepReport report = simulator.step();
    const double step_seconds = std::chrono::duration<double>(Clock::now() - before).count();
    seconds += step_seconds;
    statistics.add(report);
    outputs.add(simulator, report, step_seconds);
    progress.show(report);
  }
}

int report_end(const RunSummary& summary, uint64_t steps, bool quiet) {
  if (!quiet) fmt::print("{}", to_text(summary));
  if (const auto& failure = summary.simulator.failure()) {
    fmt::print(stderr, "sluice: invalid run: {}\n",
               failure_text(summary.scene, summary.statistics, *failure));
    return 1;
  }
  warn_of_poor_run(summary.statistics, quiet);
  if (interrupted()) {
    fmt::print(stderr, "sluice: interrupted after step {} of {}; what was asked for is written up to there\n",
               summary.simulator.steps(), steps);
  }
  return 0;
}

}  // namespace

int run_command(const RunOptions& options) {
  const Scene scene = load_scene(options.scene, options.overrides);
  const uint64_t steps = step_count(options, scene);
  limit_frames(options, scene, steps);
  refuse_clashes(options, scene);
  const bool asks_for_gpu = options.machine.backend == BackendChoice::gpu;
  require_memory(scene, options.machine.precision, available_memory(), asks_for_gpu ? gpu_memory : 1);
  const Samples samples = sample(scene);
  Machine machine(options.machine, samples.fluid.size());
  if (options.machine.backend != BackendChoice::cpu && !options.quiet)
    fmt::print(stderr, "backend: {}\n", machine.choice());
  if (!machine.gpu_backend() && !options.frames.frames && !options.frames.video)
    warn_of_unused_opengl(options.machine, options.quiet);
  for (const std::string& limit : beyond_limits(scene)) warn(options.quiet, limit);

  Simulator simulator(scene, samples, machine.backend());  // may refuse the scene: then nothing is written
  note_interrupts();                                       // from here on there is something to finish
  Outputs outputs(options, scene, samples, machine);
  RunStatistics statistics;
  RunSummary summary{scene, samples, machine.backend(), simulator, statistics};
  {
    Progress progress(steps, static_cast<double>(steps) * scene.dt, options.quiet);
    try {
      simulate(simulator, steps, outputs, progress, statistics, summary.seconds);
    } catch (const Error&) {
      outputs.save();
      throw;
    }
  }
  outputs.finish(summary);
  const int code = report_end(summary, steps, options.quiet);
  outputs.tell_of_frames(options.quiet);
  return code;
}

}  // namespace sluice
