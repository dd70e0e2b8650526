// Takes the place of checkpoint.cpp and checked_file.cpp in builds without recordings.
#include "core/output/checkpoint.hpp"
#include "sluice/error.hpp"

namespace sluice {
namespace {

[[noreturn]] void refuse() {
  throw EnvironmentError(
      "this program was built without checkpoints; run scripts/setup and build it again "
      "with -DSLUICE_RECORDINGS=ON");
}

}  // namespace

struct CheckpointWriter::State {};

CheckpointWriter::CheckpointWriter(std::filesystem::path, const Scene&, Precision, const std::string&) {
  refuse();
}
CheckpointWriter::~CheckpointWriter() = default;
CheckpointWriter::CheckpointWriter(CheckpointWriter&&) noexcept = default;
void CheckpointWriter::write(const SimulationState&, const RunCounts&) {}

Checkpoint read_checkpoint(const std::filesystem::path&) { refuse(); }

}  // namespace sluice
