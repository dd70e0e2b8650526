// Files that are either written whole or not at all: the bytes go to a temporary neighbour that takes the
// target's name only when everything is on its way to the disk. No failure passes silently, a full disk least
// of all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sluice {

/// A file being written. Without commit() the target stays as it was and the temporary file disappears.
/// Devices, pipes and /dev/stdout can't be replaced by a rename; they are written directly.
/// Every failure is an EnvironmentError with the path, the reason and what to do.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;

  void write(std::string_view bytes);

  /// Writes what is buffered, closes, and gives the file its name. Nothing may be written afterwards.
  void commit();

  /// Commits as commit() does, and returns only when the bytes and the name are on the disk: after a power
  /// cut the file is there.
  void commit_to_disk();

  /// Path that was asked for.
  const std::filesystem::path& path() const { return path_; }

  /// Path of the bytes until commit(), for another program that writes them by name instead of write(). Empty
  /// with a device or a pipe, and after commit().
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void open_temporary();
  void flush();
  void sync();
  void sync_folder();
  void discard() noexcept;
  [[noreturn]] void fail(int reason);

  std::filesystem::path path_;
  std::filesystem::path target_;     // path_ with symbolic links resolved
  std::filesystem::path temporary_;  // empty while writing directly
  std::string buffer_;
  int descriptor_ = -1;
};

/// Writes a whole file at once.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sluice
