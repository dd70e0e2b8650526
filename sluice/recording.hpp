// Recordings of runs, as `sluice run --record` writes them.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "sluice/report.hpp"
#include "sluice/sampling.hpp"

namespace sluice::media {

/// A moment of a run: all that a picture or a file of it shows. Step 0 is the start.
struct Moment {
  StepReport report;
  double seconds_per_step = 0;  ///< wall time of that step
  Snapshot state;
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

}  // namespace sluice::media
