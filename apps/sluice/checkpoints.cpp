// Which scene a run goes on with, and when its checkpoints are due.
#include "apps/sluice/checkpoints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "apps/sluice/differences.hpp"
#include "core/output/frame_clock.hpp"
#include "core/scene/settings.hpp"
#include "core/text.hpp"
#include "media/recording.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// SCENE with these overrides, of which the checkpoint's may not fit another scene.
Scene load_given(const RunOptions& options, const Checkpoint& from,
                 const std::vector<std::string>& overrides) {
  try {
    return load_scene(*options.scene, overrides);
  } catch (const InputError& error) {
    if (from.scene.record.overrides.empty()) throw;
    throw InputError(fmt::format("{} (with the overrides in {} applied first: {})", error.what(),
                                 options.resume->string(), fmt::join(from.scene.record.overrides, ", ")));
  }
}

}  // namespace

std::optional<Checkpoint> checkpoint_to_resume(const RunOptions& options) {
  if (!options.resume) return std::nullopt;
  Checkpoint from = read_checkpoint(*options.resume);
  if (from.precision != options.machine.precision) {
    throw InputError(fmt::format("{0}: found a checkpoint in {1}, expected one in {2}; give --precision {1}",
                                 options.resume->string(), name_of(from.precision),
                                 name_of(options.machine.precision)));
  }
  return from;
}

Scene scene_to_run(const RunOptions& options, const std::optional<Checkpoint>& from,
                   const std::optional<Checkpoint>& start) {
  if (options.scene) {
    media::refuse_recording(*options.scene);
    refuse_checkpoint(*options.scene);
    if (!from) return load_scene(*options.scene, options.overrides);
  }
  if (start) return changed(start->scene, options.overrides);
  if (!from)
    throw InputError(
        "run: found no SCENE, expected a scene file, the name of a shipped scene, --resume or --start-from "
        "FILE");
  const auto overrides = joined(from->scene.record.overrides, options.overrides);
  Scene scene = options.scene ? load_given(options, *from, overrides)
                              : parse_scene(from->scene.record.text, from->scene.file, overrides);
  if (const auto difference = first_difference(settings_of(from->scene), settings_of(scene))) {
    throw InputError(fmt::format(
        "{}: found a checkpoint made with {} {}, expected one with {}, as this run asks for; only "
        "output, scene and time.duration may change on the way",
        options.resume->string(), difference->key, difference->before, difference->now));
  }
  return scene;
}

Simulator make_simulator(const RunOptions& options, const Scene& scene, const Samples& samples,
                         Backend& backend, const std::optional<Checkpoint>& from,
                         std::optional<Checkpoint>& start) {
  if (start) {
    require_particles(options.start_from->string(), start->state, samples);
    return Simulator(scene, samples, backend, as_start(std::move(start->state), start->scene, scene));
  }
  if (!from) return Simulator(scene, samples, backend);
  require_particles(options.resume->string(), from->state, samples);
  return Simulator(scene, samples, backend, from->state);
}

// Below the slack that times have, every step is one of them.
CheckpointClock::CheckpointClock(double every, double time)
    : every_(std::max(every, FrameClock::slack)), passed_(passed(time)) {}

double CheckpointClock::passed(double time) const { return std::floor((time + FrameClock::slack) / every_); }

bool CheckpointClock::advance(double time) {
  const double before = std::exchange(passed_, passed(time));
  return passed_ > before;
}

Checkpoints::Checkpoints(const RunOptions& options, const Scene& scene, const Backend& backend, double time) {
  if (!options.checkpoint) return;
  name_ = options.checkpoint->string();
  writer_.emplace(*options.checkpoint, scene, backend.precision(),
                  fmt::format("{}, {}", backend.name(), backend.device()));
  if (options.checkpoint_every) clock_.emplace(*options.checkpoint_every, time);
}

void Checkpoints::write(const Simulator& simulator, const RunStatistics& statistics) {
  if (!wanted() || simulator.failure() || written_ == simulator.steps()) return;
  writer_->write(simulator.state(), statistics.counts());
  written_ = simulator.steps();
}

void Checkpoints::tell_of_last() const {
  if (!writer_) return;
  const std::string last = written_ ? fmt::format("{} has step {}, the last that was due", name_, *written_)
                           : std::filesystem::exists(name_) ? fmt::format("{} stays as it was", name_)
                                                            : "there is none";
  fmt::print(stderr, "sluice: no checkpoint of an invalid state is written; {}\n", last);
}

}  // namespace sluice::app
