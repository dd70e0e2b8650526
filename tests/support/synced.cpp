#include "tests/support/synced.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace sluice::test {
namespace {

SyncListener* listener = nullptr;  // what stands for fsync can reach nothing but a global

}  // namespace

SyncListener::SyncListener(std::filesystem::path awaited) : awaited_(std::move(awaited)) { listener = this; }
SyncListener::~SyncListener() { listener = nullptr; }

void SyncListener::hear(int descriptor) {
  std::error_code error;
  heard.push_back({std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error),
                   std::filesystem::exists(awaited_)});
}

}  // namespace sluice::test

/// Stands before the C library's, for all of this program.
extern "C" int fsync(int descriptor) {
  if (sluice::test::listener != nullptr) sluice::test::listener->hear(descriptor);
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}
