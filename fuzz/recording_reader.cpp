// libFuzzer on the reader of recordings: whatever is in a file, it is read or refused by name, in one line,
// and what is read is finite. Needs clang; Debian's clang package brings libFuzzer along.
//
//   cmake --preset fuzz && cmake --build --preset fuzz
//   mkdir -p build/fuzz/recordings
//   build/release/sluice run inclined_plane --steps 2 --fps 1000 --quiet --record build/fuzz/recordings/a.rec
//   build/fuzz/recording_reader -max_len=100000 -max_total_time=600 build/fuzz/recordings
//
// The target gives every input the right checksum and place of the index, which no fuzzer finds. New inputs
// of interest go to the folder. What breaks a claim is written to the working folder as crash-...; give that
// file as the only argument to run it again, and make a test of it (tests/media/test_recording.cpp) before
// you mend it.
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "media/recording.hpp"
#include "media/recording_format.hpp"
#include "sluice/error.hpp"
#include "tests/support/scene_claims.hpp"

namespace {

using namespace sluice;

void seal(std::string& bytes) {
  using sluice::media::Tail;
  if (bytes.size() < sizeof(Tail)) return;
  const size_t end = bytes.size() - sizeof(Tail);
  auto tail = read_from<Tail>(bytes, end);
  bytes.resize(end);
  bytes += bytes_of(end - tail.frames * sizeof(sluice::media::IndexEntry));
  bytes += bytes_of(tail.frames);
  bytes += bytes_of(XXH3_64bits(bytes.data(), bytes.size()));
  bytes += bytes_of(Tail().end);
}

/// The claim that the file breaks, or nothing.
std::string broken_by(const std::filesystem::path& path) {
  try {
    const media::Recording recording(path);
    for (size_t frame = 0; frame < recording.frames(); ++frame) recording.moment(frame);
    return test::not_finite(recording.scene());
  } catch (const InputError& error) {
    if (test::is_refusal_of(error.what(), fmt::format("{}: ", path.string()))) return "";
    return error.what();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  seal(bytes);
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("sluice_fuzz_{}.rec", getpid());
  std::ofstream(path, std::ios::binary) << bytes;
  const std::string broken = broken_by(path);
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s\n", broken.c_str());
  std::abort();
}
