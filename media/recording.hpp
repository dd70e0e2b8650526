// Recordings: the frames of a run in one file, to be watched and exported again without simulating.
// sluice/recording.hpp has their reader.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/output/output_file.hpp"
#include "sluice/recording.hpp"
#include "sluice/report.hpp"

namespace sluice::media {

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

/// Whether the file begins as a recording does, however short it was cut.
bool is_recording(const std::filesystem::path& path);

/// Throws an InputError when the file begins as a recording does: for where a scene is wanted.
void refuse_recording(const std::filesystem::path& path);

}  // namespace sluice::media
