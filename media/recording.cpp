// File -> scene, index, moments. Nothing in the file is trusted before it was checked.
#include "media/recording.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/solver/memory.hpp"
#include "core/solver/verdict.hpp"
#include "core/text.hpp"
#include "media/recording_format.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::media {
namespace {

constexpr size_t tail_size = sizeof(Tail);

/// The tail, once it is sure that every byte before it is as it was written.
Tail checked_tail(CheckedFile& source) {
  if (source.size() < source.header_offset() + tail_size) source.refuse_altered();
  const uint64_t end = source.size() - tail_size;
  const auto tail = read_from<Tail>(source.read(end, tail_size), 0);
  const bool index_fits = tail.frames > 0 && tail.frames <= end / sizeof(IndexEntry) &&
                          tail.index_offset == end - tail.frames * sizeof(IndexEntry);
  if (tail.end != Tail().end || !index_fits) source.refuse_altered();
  if (source.checksum(end + 2 * sizeof(uint64_t)) != tail.checksum) source.refuse_altered();
  return tail;
}

std::vector<IndexEntry> read_index(CheckedFile& source, const Tail& tail) {
  std::vector<IndexEntry> index(tail.frames);
  const std::string bytes = source.read(tail.index_offset, tail.frames * sizeof(IndexEntry));
  std::memcpy(index.data(), bytes.data(), bytes.size());
  return index;
}

StepReport report_of(const FrameFacts& facts) {
  StepReport report;
  report.step = facts.step;
  report.time = facts.time;
  report.dt = facts.dt;
  report.iterations = facts.iterations;
  report.residual = facts.residual;
  report.converged = facts.converged != 0;
  Diagnostics& d = report.diagnostics;
  d.mean_density = facts.mean_density;
  d.mean_compression = facts.mean_compression;
  d.max_compression = facts.max_compression;
  d.kinetic_energy = facts.kinetic_energy;
  d.potential_energy = facts.potential_energy;
  d.centre_of_mass = {facts.centre_of_mass_x, facts.centre_of_mass_y};
  d.max_speed = facts.max_speed;
  d.cfl = facts.cfl;
  d.wall_force = {facts.wall_force_x, facts.wall_force_y};
  d.lost = facts.lost;
  return report;
}

/// The opposite of the writer's append_by_bytes.
template <class Real, class Use>
void read_by_bytes(std::string_view& bytes, size_t n, Use use) {
  for (size_t i = 0; i < n; ++i) {
    std::array<char, sizeof(Real)> number;
    for (size_t b = 0; b < sizeof(Real); ++b) number[b] = bytes[b * n + i];
    use(i, static_cast<double>(std::bit_cast<Real>(number)));
  }
  bytes.remove_prefix(n * sizeof(Real));
}

template <class Real>
void read_particles(std::string_view bytes, Snapshot& state, Vec2 corner) {
  const size_t n = state.x.size();
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.x[i].x = corner.x + value; });
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.x[i].y = corner.y + value; });
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.v[i].x = value; });
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.v[i].y = value; });
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.density[i] = value; });
  read_by_bytes<Real>(bytes, n, [&](size_t i, double value) { state.pressure[i] = value; });
}

}  // namespace

struct Recording::State {
  explicit State(const std::filesystem::path& path) : source(path, recording_file_kind) {}
  mutable CheckedFile source;
  Scene scene;
  Samples samples;
  Precision precision = Precision::single_;
  std::vector<IndexEntry> index;
};

Recording::Recording(const std::filesystem::path& path, std::span<const std::string> overrides)
    : state_(std::make_unique<State>(path)) {
  State& state = *state_;
  const uint32_t header_size = state.source.read_preamble();
  state.index = read_index(state.source, checked_tail(state.source));
  const std::string header = state.source.read(state.source.header_offset(), header_size);
  std::string precision;
  try {
    const auto json = nlohmann::json::parse(header);
    auto changes = json.at("overrides").get<std::vector<std::string>>();
    changes.insert(changes.end(), overrides.begin(), overrides.end());
    state.scene =
        parse_scene(json.at("text").get<std::string>(),
                    std::filesystem::path(json.at("file").get<std::string>()).filename().string(), changes);
    require_memory(state.scene, Precision::single_, available_memory());
    state.samples = sample(state.scene);
    precision = json.at("precision").get<std::string>();
  } catch (const nlohmann::json::exception&) {
    state.source.refuse_altered();
  } catch (const InputError& error) {
    state.source.refuse(fmt::format("found a scene in it that this version can't read: {}", error.what()));
  }
  state.precision = precision == name_of(Precision::double_) ? Precision::double_ : Precision::single_;
  if (precision != name_of(state.precision)) state.source.refuse_altered();
}

Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;

const Scene& Recording::scene() const { return state_->scene; }
const Samples& Recording::samples() const { return state_->samples; }
Precision Recording::precision() const { return state_->precision; }
size_t Recording::frames() const { return state_->index.size(); }

Moment Recording::moment(size_t frame) const {
  const State& state = *state_;
  const IndexEntry& entry = state.index.at(frame);
  const size_t n = state.samples.fluid.size();
  const size_t real = state.precision == Precision::double_ ? sizeof(double) : sizeof(float);
  const std::string packed = state.source.read(entry.offset, entry.bytes);
  std::string plain(sizeof(FrameFacts) + values_per_particle * n * real, '\0');
  if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != plain.size() ||
      ZSTD_decompress(plain.data(), plain.size(), packed.data(), packed.size()) != plain.size()) {
    state.source.refuse_altered();
  }
  const auto facts = read_from<FrameFacts>(plain, 0);
  Moment moment{report_of(facts), facts.seconds_per_step, {}};
  moment.state.step = facts.step;
  moment.state.x.resize(n);
  moment.state.v.resize(n);
  moment.state.density.resize(n);
  moment.state.pressure.resize(n);
  const std::string_view particles = std::string_view(plain).substr(sizeof(FrameFacts));
  if (real == sizeof(double)) {
    read_particles<double>(particles, moment.state, state.scene.domain_min);
  } else {
    read_particles<float>(particles, moment.state, state.scene.domain_min);
  }
  if (!std::isfinite(facts.time) || !std::isfinite(facts.dt) || !std::isfinite(facts.seconds_per_step) ||
      !is_finite(moment.state))
    state.source.refuse_altered();
  return moment;
}

}  // namespace sluice::media
