// What recordings and checkpoints have in common on the disk: the first bytes say what the file is, a
// checksum covers the rest, and nothing is trusted before it was checked.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/output/file_kind.hpp"
#include "core/solver/backend.hpp"
#include "sluice/scene.hpp"

namespace sluice {

static_assert(std::endian::native == std::endian::little, "files are written as they lie in memory");

template <class T>
std::string_view bytes_of(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class T>
T read_from(std::string_view bytes, size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Checksum (XXH3, 64 bits) of bytes that come in parts.
class Checksum {
 public:
  Checksum();  ///< EnvironmentError when there is no memory
  ~Checksum();
  Checksum(Checksum&&) noexcept;
  void add(std::string_view bytes);
  uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The header of a file about a run, as JSON: the scene with its overrides, and how and where it is computed.
std::string run_header(const Scene& scene, Precision precision, const std::string& device);

/// First bytes of a file of this kind: magic, format, size of the header, header.
std::string preamble(const FileKind& kind, std::string_view header);

/// File that is read, with its name for messages.
class CheckedFile {
 public:
  /// Opens the file. InputError with the name when it can't be read.
  CheckedFile(std::filesystem::path path, const FileKind& kind);

  /// Checks the first bytes. Returns the size of the header that follows at header_offset(), which may lie.
  uint32_t read_preamble();
  uint64_t header_offset() const { return kind_.magic.size() + 2 * sizeof(uint32_t); }

  /// Reads `bytes` bytes from `offset` on. InputError where the file ends before that.
  std::string read(uint64_t offset, uint64_t bytes);
  /// Checksum of the first `bytes` bytes.
  uint64_t checksum(uint64_t bytes);
  uint64_t size() const { return size_; }

  /// Throws an InputError that begins with the name.
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuse_altered() const;

 private:
  std::filesystem::path path_;
  FileKind kind_;
  std::ifstream file_;
  static constexpr auto no_size = static_cast<uint64_t>(-1);  // as the library has it
  uint64_t size_ = 0;
};

}  // namespace sluice
