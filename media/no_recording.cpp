// Takes the place of recording.cpp and recording_writer.cpp in builds without recordings.
#include "media/recording.hpp"
#include "sluice/error.hpp"

namespace sluice::media {
namespace {

[[noreturn]] void refuse() {
  throw EnvironmentError(
      "this program was built without recordings; run scripts/setup and build it again "
      "with -DSLUICE_RECORDINGS=ON");
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

}  // namespace sluice::media
