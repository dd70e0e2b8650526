// A run that leaves checkpoints, and one that goes on from a checkpoint.
#pragma once

#include <optional>
#include <string>

#include "apps/sluice/options.hpp"
#include "core/output/checkpoint.hpp"
#include "core/output/summary.hpp"
#include "core/solver/simulator.hpp"

namespace sluice::app {

/// The checkpoint that --resume names, if it does. InputError when it can't be read or when its precision is
/// not that of this run.
std::optional<Checkpoint> checkpoint_to_resume(const RunOptions& options);

/// The scene of a run: SCENE, or the one in the checkpoint that it goes on `from` or that its `start` is,
/// with the overrides of both. InputError when there is none, or when it differs from that of the checkpoint
/// in anything that counts for the steps.
Scene scene_to_run(const RunOptions& options, const std::optional<Checkpoint>& from,
                   const std::optional<Checkpoint>& start);

/// Simulator at the scene's start, at the `start` of a checkpoint, whose state it takes, or where one left
/// off. InputError when the checkpoint has other particles.
Simulator make_simulator(const RunOptions& options, const Scene& scene, const Samples& samples,
                         Backend& backend, const std::optional<Checkpoint>& from,
                         std::optional<Checkpoint>& start);

/// Clock that says when a checkpoint is due: at the first step with time >= k T, for every k from 1 on.
class CheckpointClock {
 public:
  /// Clock with the interval `every` in the scene's time; nothing is due up to `time`.
  CheckpointClock(double every, double time);
  bool advance(double time);

 private:
  double passed(double time) const;
  double every_, passed_;
};

/// Checkpoints that --checkpoint and --checkpoint-every ask for.
class Checkpoints {
 public:
  /// Makes sure that the place can be written. `time` is that from which the run goes on.
  Checkpoints(const RunOptions& options, const Scene& scene, const Backend& backend, double time);

  /// Whether there is one to be written at all.
  bool wanted() const { return writer_ && !held_; }
  bool due(double time) { return wanted() && clock_ && clock_->advance(time); }
  /// Keeps the last checkpoint from now on, since the run is no longer that of a later end.
  void hold() { held_ = true; }
  /// Writes a checkpoint, and returns when it is on the disk. Does nothing where none is wanted, where it is
  /// there already, and after a step that failed: the last good one stays.
  void write(const Simulator& simulator, const RunStatistics& statistics);
  /// Says, after a run that became invalid, which checkpoint there is.
  void tell_of_last() const;

 private:
  std::string name_;
  std::optional<CheckpointWriter> writer_;
  std::optional<CheckpointClock> clock_;
  bool held_ = false;
  std::optional<uint64_t> written_;  ///< step of the last checkpoint
};

}  // namespace sluice::app
