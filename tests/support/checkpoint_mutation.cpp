// Mutants of checkpoints: of the whole file, or of its header or its numbers with the rest made to fit.
#include <algorithm>
#include <cmath>

#include "core/output/checkpoint.hpp"
#include "core/output/checkpoint_format.hpp"
#include "tests/support/mutated_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scene_claims.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

constexpr size_t checksum_size = sizeof(uint64_t);

/// Puts the right checksum at the end.
void seal(std::string& bytes) {
  if (bytes.size() < checksum_size) return;
  bytes.resize(bytes.size() - checksum_size);
  Checksum checksum;
  checksum.add(bytes);
  bytes += bytes_of(checksum.value());
}

std::string changed_part(const std::string& bytes, Dice& dice) {
  const size_t size_at = checkpoint_magic.size() + sizeof(uint32_t), header_at = size_at + sizeof(uint32_t);
  std::string header = bytes.substr(header_at, read_from<uint32_t>(bytes, size_at));
  std::string numbers = bytes.substr(header_at + header.size());
  if (dice.one_in(2)) {
    header = changed_header(header, dice);
  } else {
    change_numbers(numbers, dice);
  }
  std::string changed = preamble(checkpoint_file_kind, header) + numbers;
  seal(changed);
  return changed;
}

std::string mutated_checkpoint(const std::vector<std::string>& files, Dice& dice) {
  if (dice.one_in(2)) return changed_part(dice.of<std::string>(files), dice);
  std::string bytes = mutant(files, byte_mutations(), dice);
  if (!dice.one_in(4)) seal(bytes);
  return bytes;
}

bool is_finite(const std::vector<Vec2>& values) {
  return std::ranges::all_of(values, [](Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); });
}
bool is_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double a) { return std::isfinite(a); });
}

std::string read_all_of(const std::filesystem::path& path) {
  const Checkpoint found = read_checkpoint(path);
  if (const std::string problem = not_finite(found.scene); !problem.empty()) return problem;
  const SimulationState& state = found.state;
  if (!is_finite(state.x) || !is_finite(state.v)) return "a place or a velocity is not finite";
  if (!is_finite(state.density) || !is_finite(state.pressure)) return "a density or a pressure is not finite";
  if (!std::isfinite(state.clock.time()) || !std::isfinite(state.clock.dt)) return "a time is not finite";
  if (!state.diagnostics.finite() || !std::isfinite(state.diagnostics.cfl)) return "a total is not finite";
  if (!std::isfinite(found.counts.compression_sum)) return "a sum over the steps is not finite";
  return "";
}

}  // namespace

FileKind checkpoint_kind() {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    Simulation simulation(shipped("inclined_plane"), precision);
    RunStatistics statistics;
    for (const StepReport& report : simulation.run(2)) statistics.add(report);
    CheckpointWriter writer(folder / "a.ckp", simulation.scene, precision, "a machine");
    writer.write(simulation.simulator->state(), statistics.counts());
    files.push_back(read_file(folder / "a.ckp"));
  }
  return {"ckp", [files](Dice& dice) { return mutated_checkpoint(files, dice); }, read_all_of};
}

}  // namespace sluice::test
