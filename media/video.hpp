// Pictures of a run as an H.264 video in an MP4 file, encoded by the program ffmpeg while the run goes on.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/output/output_file.hpp"
#include "draw/image.hpp"

namespace sluice::media {

/// A video being written. Like every output it has its name only once it is whole: after finish().
class VideoFile {
 public:
  /// Starts ffmpeg. `size` in pixels; odd ones are padded to even ones. InputError when `path` does not end
  /// in .mp4 or is a device or a pipe; EnvironmentError when ffmpeg is not installed or `path` can't be
  /// written.
  VideoFile(std::filesystem::path path, glm::uvec2 size, double pictures_per_second);
  ~VideoFile();  ///< without finish(): ends ffmpeg and leaves no file
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Writes one frame, of the size given at the start; waits while ffmpeg is busy. EnvironmentError with what
  /// ffmpeg said when it has given up; every later call says so again.
  void write(const draw::Image& image);

  /// Waits for ffmpeg and gives the file its name; a second call does nothing. Without a picture there is no
  /// file. EnvironmentError as in write(). Nothing may be written afterwards.
  void finish();

  uint64_t count() const { return count_; }  ///< pictures so far

 private:
  void start(double pictures_per_second);
  int end();
  [[noreturn]] void fail(int status);
  std::string what_ffmpeg_said() const;

  std::filesystem::path path_;
  glm::uvec2 size_;
  std::optional<OutputFile> file_;  // none after finish() or a failure
  pid_t ffmpeg_ = -1;
  int pictures_ = -1;  // our end of ffmpeg's standard input
  int messages_ = -1;  // its standard error, a file without a name
  uint64_t count_ = 0;
  std::string failure_;
};

}  // namespace sluice::media
