// Takes the place of recording.cpp, recording_writer.cpp, checkpoint.cpp and checked_file.cpp in builds
// without recordings.
#include <fmt/format.h>

#include "core/error.hpp"
#include "media/checkpoint.hpp"
#include "media/recording.hpp"

namespace sluice {
namespace {

[[noreturn]] void refuse(const char* what = "recordings") {
  throw EnvironmentError(
      fmt::format("this program was built without {}; install libzstd-dev and libxxhash-dev and build it "
                  "again with -DSLUICE_RECORDINGS=ON",
                  what));
}

}  // namespace

struct RecordingWriter::State {};
struct Recording::State {};

RecordingWriter::RecordingWriter(const std::filesystem::path&, const Scene&, Precision, const std::string&) {
  refuse();
}
RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
void RecordingWriter::add(const StepReport&, double, const Snapshot&) {}
size_t RecordingWriter::frames() const { return 0; }
void RecordingWriter::commit() {}

Recording::Recording(const std::filesystem::path&, std::span<const std::string>) { refuse(); }
Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;
const Scene& Recording::scene() const { refuse(); }
const Samples& Recording::samples() const { refuse(); }
Precision Recording::precision() const { refuse(); }
size_t Recording::frames() const { return 0; }
Moment Recording::moment(size_t) const { return {}; }

struct CheckpointWriter::State {};

CheckpointWriter::CheckpointWriter(std::filesystem::path, const Scene&, Precision, const std::string&) {
  refuse("checkpoints");
}
CheckpointWriter::~CheckpointWriter() = default;
CheckpointWriter::CheckpointWriter(CheckpointWriter&&) noexcept = default;
void CheckpointWriter::write(const SimulationState&, const RunCounts&) {}

Checkpoint read_checkpoint(const std::filesystem::path&) { refuse("checkpoints"); }

}  // namespace sluice
