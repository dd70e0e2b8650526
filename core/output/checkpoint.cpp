// State -> file -> state. Nothing in the file is trusted before it was checked.
#include "core/output/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "core/output/checkpoint_format.hpp"
#include "core/output/output_file.hpp"
#include "core/solver/memory.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice {
namespace {

constexpr uint64_t most_steps = 1'000'000'000'000'000;  // as of a run
constexpr size_t checksum_size = sizeof(uint64_t);

std::span<const double> flat(const std::vector<Vec2>& values) {
  return {reinterpret_cast<const double*>(values.data()), 2 * values.size()};
}
std::span<double> flat(std::vector<Vec2>& values) {
  return {reinterpret_cast<double*>(values.data()), 2 * values.size()};
}

template <class Real>
std::string as_bytes(std::span<const double> values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(Real));
  for (const double value : values) bytes += bytes_of(static_cast<Real>(value));
  return bytes;
}

template <class Real>
bool from_bytes(std::string_view bytes, std::span<double> values) {
  bool finite = true;
  for (size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<double>(read_from<Real>(bytes, i * sizeof(Real)));
    finite = finite && std::isfinite(values[i]);
  }
  return finite;
}

/// Diagnostics as numbers, to be read or written in this order.
auto numbers_of(auto& d) {
  return std::array{
      &d.mean_density,     &d.mean_compression, &d.max_compression, &d.kinetic_energy,   &d.potential_energy,
      &d.centre_of_mass.x, &d.centre_of_mass.y, &d.max_speed,       &d.max_speed_change, &d.cfl,
      &d.wall_force.x,     &d.wall_force.y};
}

bool is_plausible(const RunClock& clock, const Scene& scene) {
  const bool times = clock.time_before >= 0 && std::isfinite(clock.time()) && clock.dt > 0;
  if (!times || clock.steps > most_steps || clock.steps_before > clock.steps) return false;
  if (!scene.adaptive) return clock.dt == scene.dt && clock.next_dt == 0;
  const AdaptiveStep& limits = *scene.adaptive;
  return clock.dt <= limits.dt_max && clock.next_dt >= limits.dt_min && clock.next_dt <= limits.dt_max;
}

bool is_plausible(const RunCounts& counts, const RunClock& clock, uint64_t particles) {
  const bool positive = counts.compression_sum >= 0 && counts.compression_max >= 0 && counts.cfl_max >= 0 &&
                        counts.dt_min > 0 && counts.dt_max >= 0 && counts.lost <= particles;
  const bool finite = std::isfinite(counts.compression_sum) && std::isfinite(counts.compression_max) &&
                      std::isfinite(counts.cfl_max) && std::isfinite(counts.dt_max);
  return positive && finite && counts.steps == clock.steps && counts.not_converged <= counts.steps;
}

/// Offsets of the parts of a file whose header has this size.
struct Parts {
  uint64_t header = 0, facts = 0, particles = 0, checksum = 0;
};

/// The parts, once it is sure that every byte is as it was written.
Parts checked_parts(CheckedFile& file) {
  const uint32_t header_size = file.read_preamble();
  Parts parts;
  parts.header = file.header_offset();
  parts.facts = parts.header + header_size;
  parts.particles = parts.facts + sizeof(CheckpointFacts);
  if (file.size() < parts.particles + checksum_size) file.refuse_altered();
  parts.checksum = file.size() - checksum_size;
  if (file.checksum(parts.checksum) != read_from<uint64_t>(file.read(parts.checksum, checksum_size), 0))
    file.refuse_altered();
  return parts;
}

struct Header {
  std::string precision, file, text;
  std::vector<std::string> overrides;
};

Header read_header(CheckedFile& file, const Parts& parts) {
  try {
    const auto json = nlohmann::json::parse(file.read(parts.header, parts.facts - parts.header));
    Header header;
    json.at("precision").get_to(header.precision);
    json.at("file").get_to(header.file);
    json.at("text").get_to(header.text);
    json.at("overrides").get_to(header.overrides);
    if (header.precision == name_of(Precision::single_) || header.precision == name_of(Precision::double_))
      return header;
  } catch (const nlohmann::json::exception&) {
  }
  file.refuse_altered();
}

Scene scene_in(CheckedFile& file, const Header& header, Precision precision) {
  try {
    Scene scene =
        parse_scene(header.text, std::filesystem::path(header.file).filename().string(), header.overrides);
    require_memory(scene, precision, available_memory());
    return scene;
  } catch (const InputError& error) {
    file.refuse(fmt::format("found a scene in it that can't be run here: {}", error.what()));
  }
}

void read_state(CheckedFile& file, const Parts& parts, Checkpoint& found) {
  const auto facts = read_from<CheckpointFacts>(file.read(parts.facts, sizeof(CheckpointFacts)), 0);
  const bool wide = found.precision == Precision::double_;
  const uint64_t each = checkpoint_values_per_particle * (wide ? sizeof(double) : sizeof(float));
  const uint64_t bytes = parts.checksum - parts.particles;
  if (facts.particles == 0 || facts.particles > bytes / each || facts.particles * each != bytes ||
      !is_plausible(facts.clock, found.scene) || !is_plausible(facts.counts, facts.clock, facts.particles)) {
    file.refuse_altered();
  }
  found.counts = facts.counts;
  SimulationState& state = found.state;
  state.clock = facts.clock;
  size_t k = 0;
  for (double* number : numbers_of(state.diagnostics)) *number = facts.diagnostics[k++];
  if (!std::ranges::all_of(facts.diagnostics, [](double number) { return std::isfinite(number); }))
    file.refuse_altered();
  state.diagnostics.lost = facts.counts.lost;
  state.x.resize(facts.particles);
  state.v.resize(facts.particles);
  state.density.resize(facts.particles);
  state.pressure.resize(facts.particles);
  uint64_t at = parts.particles;
  for (const std::span<double> values :
       {flat(state.x), flat(state.v), std::span(state.density), std::span(state.pressure)}) {
    const uint64_t size = values.size() * each / checkpoint_values_per_particle;
    const std::string part = file.read(at, size);
    if (!(wide ? from_bytes<double>(part, values) : from_bytes<float>(part, values))) file.refuse_altered();
    at += size;
  }
}

}  // namespace

struct CheckpointWriter::State {
  std::filesystem::path path;
  std::string start;
  Precision precision;
  std::optional<OutputFile> file;  ///< of the next one; opened before it is needed only at first
};

CheckpointWriter::CheckpointWriter(std::filesystem::path path, const Scene& scene, Precision precision,
                                   const std::string& device) {
  OutputFile first(path);
  state_ = std::make_unique<State>(State{std::move(path),
                                         preamble(checkpoint_file_kind, run_header(scene, precision, device)),
                                         precision, std::move(first)});
}

CheckpointWriter::~CheckpointWriter() = default;
CheckpointWriter::CheckpointWriter(CheckpointWriter&&) noexcept = default;

void CheckpointWriter::write(const SimulationState& state, const RunCounts& counts) {
  OutputFile file = state_->file ? std::move(*state_->file) : OutputFile(state_->path);
  state_->file.reset();
  Checksum checksum;
  const auto put = [&](std::string_view bytes) {
    checksum.add(bytes);
    file.write(bytes);
  };
  put(state_->start);
  CheckpointFacts facts{state.x.size(), state.clock, counts, {}};
  size_t k = 0;
  for (const double* number : numbers_of(state.diagnostics)) facts.diagnostics[k++] = *number;
  put(bytes_of(facts));
  for (const std::span<const double> values :
       {flat(state.x), flat(state.v), std::span(state.density), std::span(state.pressure)}) {
    put(state_->precision == Precision::double_ ? as_bytes<double>(values) : as_bytes<float>(values));
  }
  file.write(bytes_of(checksum.value()));
  file.commit_to_disk();
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  CheckedFile file(path, checkpoint_file_kind);
  const Parts parts = checked_parts(file);
  const Header header = read_header(file, parts);
  Checkpoint found;
  found.precision = header.precision == name_of(Precision::double_) ? Precision::double_ : Precision::single_;
  found.scene = scene_in(file, header, found.precision);
  read_state(file, parts, found);
  return found;
}

}  // namespace sluice
