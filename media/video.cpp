// ffmpeg as a child process that reads raw pictures and writes the temporary file of an OutputFile.
#include "media/video.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include "sluice/error.hpp"

namespace sluice::media {
namespace {

namespace fs = std::filesystem;

void close_once(int& descriptor) {
  if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

void check_target(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_other(path, ignored))
    throw InputError(fmt::format("{}: found a device or a pipe, expected a file: mp4 needs to go back in it",
                                 path.string()));
  if (path.extension() != ".mp4")
    throw InputError(
        fmt::format("{}: expected a name that ends in .mp4, the one kind of video there is", path.string()));
}

/// H.264 with a quarter of the colour samples is what every player takes. Its pictures have even sizes: odd
/// ones get a white row or column. The colours are those of BT.709, in the conversion as in the file's tags.
std::vector<std::string> arguments(glm::uvec2 size, double pictures_per_second, const fs::path& target) {
  return {"ffmpeg", "-nostdin", "-loglevel", "error", "-xerror", "-y",
          // what comes in; seventeen digits, of which ffmpeg makes the ratio that was meant
          "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", fmt::format("{}x{}", size.x, size.y), "-framerate",
          fmt::format("{:.17g}", pictures_per_second), "-i", "pipe:0",
          // how it is converted
          "-vf",
          "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,"
          "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int",
          "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
          "-color_range", "tv",
          // what goes out; left to choose, ffmpeg takes 240 for 250 with some sizes and drops pictures
          "-r", fmt::format("{:.17g}", pictures_per_second), "-fps_mode", "passthrough", "-c:v", "libx264",
          "-crf", "16", "-movflags", "+faststart", "-f", "mp4", fmt::format("file:{}", target.string())};
}

/// A process group of its own keeps the terminal's Ctrl-C from it: the run ends in order, and so does the
/// video. A broken pipe, which this program may ignore, is ffmpeg's to hear of. 0 or why it could not be
/// started.
int spawn(std::vector<std::string> words, int input, int messages, pid_t& pid) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &defaults);

  const int failed = posix_spawnp(&pid, pointers[0], &files, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  return failed;
}

/// Moves a descriptor beyond the numbers of standard input, output and error: where this program was started
/// without those, files get their numbers, which ffmpeg's own would then take from them.
int beyond_standard(int descriptor) {
  if (descriptor < 0 || descriptor > STDERR_FILENO) return descriptor;
  const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  close(descriptor);
  return moved;
}

/// The status of a process that ended with code 255.
constexpr int unknown_status = 0xff00;

std::string start_failure(const fs::path& path, int reason) {
  if (reason == ENOENT)
    return fmt::format("{}: a video needs ffmpeg, which is not installed; install the package ffmpeg",
                       path.string());
  return fmt::format("{}: a video needs ffmpeg, which can't be started: {}; check the package ffmpeg",
                     path.string(), std::strerror(reason));
}

}  // namespace

VideoFile::VideoFile(fs::path path, glm::uvec2 size, double pictures_per_second)
    : path_(std::move(path)), size_(size) {
  check_target(path_);
  file_.emplace(path_);
  start(pictures_per_second);
}

VideoFile::~VideoFile() {
  if (ffmpeg_ > 0) kill(-ffmpeg_, SIGKILL);
  end();
  close_once(messages_);
}

/// A pair of sockets serves as the pipe, since a socket can be written without a signal when ffmpeg is gone.
void VideoFile::start(double pictures_per_second) {
  std::array<int, 2> ends{-1, -1};
  messages_ = beyond_standard(memfd_create("ffmpeg", MFD_CLOEXEC));
  int reason = messages_ < 0 ? errno : 0;
  if (reason == 0 && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) reason = errno;
  ends[0] = beyond_standard(ends[0]);
  if (reason == 0)
    reason = spawn(arguments(size_, pictures_per_second, file_->temporary()), ends[0], messages_, ffmpeg_);
  close_once(ends[0]);
  pictures_ = ends[1];
  if (reason == 0) return;
  ffmpeg_ = -1;
  close_once(pictures_);
  close_once(messages_);
  throw EnvironmentError(start_failure(path_, reason));
}

void VideoFile::write(const draw::Image& image) {
  if (!failure_.empty()) throw EnvironmentError(failure_);
  if (!file_) throw Error(fmt::format("{}: written to after it was finished", path_.string()));
  if (image.width != size_.x || image.height != size_.y || image.rgb.size() != size_t{3} * size_.x * size_.y)
    throw Error(fmt::format("{}: a picture of {} x {} pixels in a video of {} x {}", path_.string(),
                            image.width, image.height, size_.x, size_.y));
  for (size_t done = 0; done < image.rgb.size();) {
    const ssize_t sent = send(pictures_, image.rgb.data() + done, image.rgb.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail(end());
    done += static_cast<size_t>(sent);
  }
  ++count_;
}

void VideoFile::finish() {
  if (!failure_.empty()) throw EnvironmentError(failure_);
  if (!file_) return;
  const int status = end();
  if (count_ > 0 && status != 0) fail(status);
  if (count_ > 0) file_->commit();
  file_.reset();
}

/// Says that no picture follows and waits for ffmpeg's end. Its status as of waitpid.
int VideoFile::end() {
  close_once(pictures_);
  int status = 0;
  pid_t ended = ffmpeg_;
  while (ffmpeg_ > 0 && (ended = waitpid(ffmpeg_, &status, 0)) < 0 && errno == EINTR) continue;
  if (ended < 0) status = unknown_status;  // somebody else has waited, or SIGCHLD is ignored
  ffmpeg_ = -1;
  return status;
}

void VideoFile::fail(int status) {
  const std::string how = WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                              : fmt::format("gave up with code {}", WEXITSTATUS(status));
  failure_ = fmt::format(
      "cannot write {}: ffmpeg {}: {}; check that there is space and that this ffmpeg has the encoder "
      "libx264",
      path_.string(), how, what_ffmpeg_said());
  file_.reset();
  throw EnvironmentError(failure_);
}

/// Last messages of ffmpeg; the reason comes last, and a bad disk can make it say much.
std::string VideoFile::what_ffmpeg_said() const {
  constexpr off_t longest = 2000;
  const off_t length = lseek(messages_, 0, SEEK_END);
  std::string text(static_cast<size_t>(std::clamp<off_t>(length, 0, longest)), '\0');
  const ssize_t read = pread(messages_, text.data(), text.size(), std::max<off_t>(length - longest, 0));
  text.resize(static_cast<size_t>(std::max<ssize_t>(read, 0)));
  text.erase(text.find_last_not_of(" \r\n") + 1);
  return text.empty() ? "it said nothing" : text;
}

}  // namespace sluice::media
