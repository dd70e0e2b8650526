// What the program asked the disk to keep.
#pragma once

#include <filesystem>
#include <vector>

namespace sluice::test {

/// What fsync was called for, and whether the file that was awaited had its name by then.
struct Synced {
  std::filesystem::path path;
  bool named;
};

/// Calls of fsync in this process while it exists; one at a time.
class SyncListener {
 public:
  explicit SyncListener(std::filesystem::path awaited);
  ~SyncListener();
  SyncListener(const SyncListener&) = delete;
  SyncListener& operator=(const SyncListener&) = delete;

  void hear(int descriptor);
  std::vector<Synced> heard;

 private:
  std::filesystem::path awaited_;
};

}  // namespace sluice::test
