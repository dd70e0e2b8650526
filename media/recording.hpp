// Recordings: the frames of a run in one file, to be watched and exported again without simulating.
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/output/output_file.hpp"
#include "core/scene/sampling.hpp"
#include "core/solver/backend.hpp"
#include "core/solver/report.hpp"

namespace sluice::media {

/// A moment of a run: all that a picture or a file of it shows. Step 0 is the start.
struct Moment {
  StepReport report;
  double seconds_per_step = 0;  ///< wall time of that step
  Snapshot state;
};

/// Writes a recording: the scene as it was run, then one compressed block per frame, an index and a checksum
/// (docs/output.md). Numbers are kept with the bits that the run computed. Failures as of OutputFile.
class RecordingWriter {
 public:
  /// `device` says where the run was computed, for people.
  RecordingWriter(const std::filesystem::path& path, const Scene& scene, Precision precision,
                  const std::string& device);
  ~RecordingWriter();
  RecordingWriter(RecordingWriter&&) noexcept;

  /// Adds the next frame. One of the same step as the last takes no room.
  void add(const StepReport& report, double seconds_per_step, const Snapshot& state);

  size_t frames() const;

  /// Writes the index and gives the file its name. Without a frame there is no file.
  void commit();

 private:
  struct State;
  void write(std::string_view bytes);

  std::unique_ptr<State> state_;
};

/// Reads a recording. Any frame can be had at any time.
class Recording {
 public:
  /// Reads the scene and checks that every byte of the file is as it was written. `overrides` change the
  /// scene's section `output` as --set does. InputError, with the file's name and what is wrong, when it is
  /// no recording, was cut off or altered, or was made by a later version of Sluice.
  explicit Recording(const std::filesystem::path& path, std::span<const std::string> overrides = {});
  ~Recording();
  Recording(Recording&&) noexcept;

  const Scene& scene() const;
  const Samples& samples() const;
  Precision precision() const;

  size_t frames() const;  ///< one or more
  /// Reads and unpacks a frame. InputError when it changed since the file was opened.
  Moment moment(size_t frame) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether the file begins as a recording does, however short it was cut.
bool is_recording(const std::filesystem::path& path);

/// Throws an InputError when the file begins as a recording does: for where a scene is wanted.
void refuse_recording(const std::filesystem::path& path);

}  // namespace sluice::media
