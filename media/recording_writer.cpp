// Moments -> blocks compressed by Zstandard -> file.
#include <fmt/format.h>
#include <zstd.h>

#include "core/output/summary.hpp"
#include "core/text.hpp"
#include "media/recording.hpp"
#include "media/recording_format.hpp"
#include "sluice/error.hpp"

namespace sluice::media {
namespace {

constexpr int compression_level = 3;

FrameFacts facts_of(const StepReport& report, double seconds_per_step) {
  const Diagnostics& d = report.diagnostics;
  FrameFacts facts;
  facts.step = report.step;
  facts.iterations = report.iterations;
  facts.converged = report.converged ? 1 : 0;
  facts.lost = d.lost;
  facts.time = report.time;
  facts.dt = report.dt;
  facts.residual = report.residual;
  facts.seconds_per_step = seconds_per_step;
  facts.mean_density = d.mean_density;
  facts.mean_compression = d.mean_compression;
  facts.max_compression = d.max_compression;
  facts.kinetic_energy = d.kinetic_energy;
  facts.potential_energy = d.potential_energy;
  facts.centre_of_mass_x = d.centre_of_mass.x;
  facts.centre_of_mass_y = d.centre_of_mass.y;
  facts.max_speed = d.max_speed;
  facts.cfl = d.cfl;
  facts.wall_force_x = d.wall_force.x;
  facts.wall_force_y = d.wall_force.y;
  return facts;
}

/// Appends one array with the first bytes of all numbers first, then the second ones, and so on: bytes that
/// hardly differ lie together, which packs better.
template <class Real, class Value>
void append_by_bytes(std::string& out, size_t n, Value value) {
  const size_t start = out.size();
  out.resize(start + n * sizeof(Real));
  for (size_t i = 0; i < n; ++i) {
    const Real number = static_cast<Real>(value(i));
    const std::string_view bytes = bytes_of(number);
    for (size_t b = 0; b < sizeof(Real); ++b) out[start + b * n + i] = bytes[b];
  }
}

template <class Real>
void append_particles(std::string& out, const Snapshot& state, Vec2 corner) {
  const size_t n = state.x.size();
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.x[i].x - corner.x; });
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.x[i].y - corner.y; });
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.v[i].x; });
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.v[i].y; });
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.density[i]; });
  append_by_bytes<Real>(out, n, [&](size_t i) { return state.pressure[i]; });
}

}  // namespace

struct RecordingWriter::State {
  State(const std::filesystem::path& path, Precision kept, Vec2 from)
      : file(path), precision(kept), corner(from) {}

  OutputFile file;
  Precision precision;
  Vec2 corner;
  uint64_t written = 0;
  Checksum checksum;
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> packer{ZSTD_createCCtx(), &ZSTD_freeCCtx};
  std::vector<IndexEntry> index;
  std::string plain, packed;  // kept between frames
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const Scene& scene, Precision precision,
                                 const std::string& device)
    : state_(std::make_unique<State>(path, precision, scene.domain_min)) {
  if (!state_->packer)
    throw EnvironmentError(fmt::format("{}: no memory to write a recording", path.string()));
  ZSTD_CCtx_setParameter(state_->packer.get(), ZSTD_c_compressionLevel, compression_level);
  ZSTD_CCtx_setParameter(state_->packer.get(), ZSTD_c_checksumFlag, 1);
  write(preamble(recording_file_kind, run_header(scene, precision, device)));
}

RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;

void RecordingWriter::write(std::string_view bytes) {
  state_->checksum.add(bytes);
  state_->file.write(bytes);
  state_->written += bytes.size();
}

void RecordingWriter::add(const StepReport& report, double seconds_per_step, const Snapshot& particles) {
  State& state = *state_;
  if (!state.index.empty() && state.index.back().step == report.step) {
    state.index.push_back(state.index.back());
    return;
  }
  state.plain = bytes_of(facts_of(report, seconds_per_step));
  if (state.precision == Precision::double_) {
    append_particles<double>(state.plain, particles, state.corner);
  } else {
    append_particles<float>(state.plain, particles, state.corner);
  }
  state.packed.resize(ZSTD_compressBound(state.plain.size()));
  const size_t size = ZSTD_compress2(state.packer.get(), state.packed.data(), state.packed.size(),
                                     state.plain.data(), state.plain.size());
  if (ZSTD_isError(size) != 0)
    throw EnvironmentError(
        fmt::format("{}: a frame can't be packed: {}", state.file.path().string(), ZSTD_getErrorName(size)));
  state.index.push_back({state.written, size, report.step, report.time});
  write(std::string_view(state.packed).substr(0, size));
}

size_t RecordingWriter::frames() const { return state_->index.size(); }

void RecordingWriter::commit() {
  State& state = *state_;
  if (state.index.empty()) return;
  Tail tail;
  tail.index_offset = state.written;
  tail.frames = state.index.size();
  for (const IndexEntry& entry : state.index) write(bytes_of(entry));
  write(bytes_of(tail.index_offset));
  write(bytes_of(tail.frames));
  tail.checksum = state.checksum.value();
  write(bytes_of(tail.checksum));
  write(bytes_of(tail.end));
  state.file.commit();
}

}  // namespace sluice::media
