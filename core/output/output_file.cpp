// OutputFile over POSIX calls, since streams hide why a write failed.
#include "core/output/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <utility>

#include "sluice/error.hpp"

namespace sluice {
namespace {

constexpr size_t buffer_size = size_t{1} << 16;

// What the user can do about the reason of a failed open, write or rename.
const char* advice(int reason) {
  switch (reason) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return "free some space or write somewhere else";
    case ENOENT:
    case ENOTDIR: return "create its folder first or name an existing one";
    case EISDIR: return "name a file, not a folder";
    case EACCES:
    case EPERM:
    case EROFS:
    case ETXTBSY: return "choose a place that may be written";
    case ENAMETOOLONG: return "choose a shorter name";
    default: return "check the disk or write somewhere else";
  }
}

// /dev/stdout, /dev/stderr, /dev/fd/N and /proc/self/fd/N name an open file of this process: when it is a
// regular file, opening it by name again would truncate it or start over at its beginning.
std::optional<int> open_descriptor(const std::filesystem::path& path) {
  const std::string name = path.lexically_normal().string();
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    int descriptor = -1;
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + folder.size(), end, descriptor);
    if (error == std::errc{} && rest == end) return descriptor;
  }
  return std::nullopt;
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), target_(path_) {
  if (path_.empty()) throw EnvironmentError("cannot write a file without a name; give one");
  buffer_.reserve(buffer_size);
  if (const auto descriptor = open_descriptor(path_)) {
    descriptor_ = fcntl(*descriptor, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  struct stat status {};
  const bool exists = stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  if (exists) {
    // A rename needs no right to write the old file; a file that was protected must stay.
    if (access(path_.c_str(), W_OK) != 0) fail(errno);
    std::error_code error;
    target_ = std::filesystem::canonical(path_, error);
    if (error) fail(error.value());
  } else if (!path_.has_filename()) {
    fail(EISDIR);
  }
  open_temporary();
  if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
}

OutputFile::~OutputFile() { discard(); }

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  path_ = std::move(other.path_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  buffer_ = std::move(other.buffer_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

// The temporary name does not contain the target's, which may be as long as a name can be.
void OutputFile::open_temporary() {
  for (uint32_t attempt = 0;; ++attempt) {
    auto name = target_.parent_path() / fmt::format(".sluice-{}-{}.tmp", getpid(), attempt);
    descriptor_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = std::move(name);
      return;
    }
    if (errno != EEXIST) fail(errno);
  }
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const size_t part = std::min(bytes.size(), buffer_size - buffer_.size());
    buffer_.append(bytes.substr(0, part));
    bytes.remove_prefix(part);
    if (buffer_.size() == buffer_size) flush();
  }
}

void OutputFile::flush() {
  if (descriptor_ < 0) throw Error(fmt::format("{}: written to after it was finished", path_.string()));
  for (std::string_view rest = buffer_; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(written < 0 ? errno : EIO);
    rest.remove_prefix(static_cast<size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  // A network file system may report a full disk only here.
  if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (!temporary_.empty() && rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::commit_to_disk() {
  const bool renamed = !temporary_.empty();
  flush();
  sync();
  commit();
  if (renamed) sync_folder();
}

// Pipes and some devices have nothing to wait for.
void OutputFile::sync() {
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) fail(errno);
}

// A folder that may be written but not read can't be opened for this; the file has its name all the same.
void OutputFile::sync_folder() {
  const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return;
  sync();
  close(std::exchange(descriptor_, -1));
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::fail(int reason) {
  discard();
  throw EnvironmentError(
      fmt::format("cannot write {}: {}; {}", path_.string(), std::strerror(reason), advice(reason)));
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace sluice
