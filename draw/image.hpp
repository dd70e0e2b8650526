// A picture in memory and on disk: PNG encoding, and a writer that does it on a second thread, because
// encoding a picture takes longer than drawing it.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "sluice/pictures.hpp"

namespace sluice::draw {

/// Encodes a picture as the bytes of a PNG file. InputError when the picture is empty or beyond a gibibyte.
std::string encode_png(const Image& image);

/// Encodes and writes pictures on its own thread, in the order given. At most `queue_limit` pictures wait: a
/// caller that is faster than the disk is held up in write() instead of filling the memory.
class PngWriter {
 public:
  explicit PngWriter(size_t queue_limit = 4);
  ~PngWriter();  ///< writes what still waits; a failure nobody asked for with finish() is lost
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  /// Puts a picture into the queue. Throws the failure of an earlier picture, the first there was.
  void write(std::filesystem::path path, Image image);

  /// Waits until all pictures so far have been written; throws the first failure.
  void flush();

  /// Waits as flush() does. Nothing may be written afterwards.
  void finish();

 private:
  void work();
  void stop() noexcept;

  const size_t queue_limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::filesystem::path, Image>> queue_;
  std::exception_ptr failure_;
  bool stopping_ = false, writing_ = false;
  std::thread thread_;  // last, so that everything it uses exists
};

}  // namespace sluice::draw
