// PNG encoding by stb_image_write, which is compiled in this file only.
#include "draw/image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/output/output_file.hpp"
#include "sluice/error.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace sluice::draw {
namespace {

constexpr uint64_t size_limit = uint64_t{1} << 30;  // the encoder counts bytes in int and doubles its buffers

}  // namespace

std::string encode_png(const Image& image) {
  const uint64_t bytes = uint64_t{image.width} * image.height * 3;
  if (bytes == 0 || bytes != image.rgb.size() || bytes + image.height > size_limit) {
    throw InputError(
        fmt::format("a picture of {} x {} pixels with {} bytes cannot be a PNG; choose another size",
                    image.width, image.height, image.rgb.size()));
  }
  std::string png;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  const int done =
      stbi_write_png_to_func(append, &png, static_cast<int>(image.width), static_cast<int>(image.height), 3,
                             image.rgb.data(), static_cast<int>(image.width * 3));
  if (done == 0) throw EnvironmentError("no memory to encode a picture; choose a smaller size");
  return png;
}

PngWriter::PngWriter(size_t queue_limit)
    : queue_limit_(std::max<size_t>(queue_limit, 1)), thread_(&PngWriter::work, this) {}

PngWriter::~PngWriter() { stop(); }

void PngWriter::write(std::filesystem::path path, Image image) {
  std::unique_lock lock(mutex_);
  if (stopping_) throw Error(fmt::format("{}: written after the last picture", path.string()));
  changed_.wait(lock, [this] { return failure_ || queue_.size() < queue_limit_; });
  if (failure_) std::rethrow_exception(failure_);
  queue_.emplace_back(std::move(path), std::move(image));
  changed_.notify_all();
}

void PngWriter::flush() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || (queue_.empty() && !writing_); });
  if (failure_) std::rethrow_exception(failure_);
}

void PngWriter::finish() {
  stop();
  if (failure_) std::rethrow_exception(failure_);
}

void PngWriter::stop() noexcept {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void PngWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
    if (queue_.empty()) return;
    const auto [path, image] = std::move(queue_.front());
    queue_.pop_front();
    writing_ = true;
    changed_.notify_all();
    lock.unlock();
    std::exception_ptr failure;
    try {
      write_file(path, encode_png(image));
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    writing_ = false;
    changed_.notify_all();
    if (failure) {
      failure_ = failure;
      queue_.clear();
      return;
    }
  }
}

}  // namespace sluice::draw
