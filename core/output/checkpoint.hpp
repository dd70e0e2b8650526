// Checkpoints: the state of a run in a file, from which it goes on as if it had never stopped.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/output/summary.hpp"
#include "core/solver/backend.hpp"
#include "core/solver/simulation_state.hpp"

namespace sluice {

/// Writes checkpoints of a run under one name, each in the place of the one before it. Whatever happens, the
/// name stands for a whole one.
class CheckpointWriter {
 public:
  /// Makes sure that the place can be written. `device` says where the run is computed, for people. Failures
  /// as of OutputFile.
  CheckpointWriter(std::filesystem::path path, const Scene& scene, Precision precision,
                   const std::string& device);
  ~CheckpointWriter();
  CheckpointWriter(CheckpointWriter&&) noexcept;

  /// Writes a checkpoint, and returns when it is on the disk.
  void write(const SimulationState& state, const RunCounts& counts);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct Checkpoint {
  Scene scene;  ///< as it was run, the overrides included
  Precision precision = Precision::single_;
  SimulationState state;
  RunCounts counts;
};

/// Reads a checkpoint. InputError, with the file's name and what is wrong, when it is no checkpoint, was cut
/// off or altered, or was made by another version of the format. Whether the particles are as many as the
/// scene has is for whoever samples it to say.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// Throws an InputError when the file begins as a checkpoint does: for where a scene is wanted.
void refuse_checkpoint(const std::filesystem::path& path);

}  // namespace sluice
