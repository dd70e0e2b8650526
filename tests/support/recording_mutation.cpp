// Mutants of recordings: of the whole file, or of one of its parts with the rest made to fit.
#include <fmt/format.h>
#include <xxhash.h>
#include <zstd.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "core/solver/verdict.hpp"
#include "media/recording_format.hpp"
#include "sluice/error.hpp"
#include "tests/support/mutated_files.hpp"
#include "tests/support/recorded.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scene_claims.hpp"

namespace sluice::test {
namespace {

using namespace media;

/// A recording taken apart; frames are unpacked.
struct Parts {
  std::string header;
  std::vector<std::string> frames;
  std::vector<IndexEntry> index;
};

Parts taken_apart(const std::string& bytes) {
  Parts parts;
  const size_t header = media::recording_magic.size() + 2 * sizeof(uint32_t);
  parts.header =
      bytes.substr(header, read_from<uint32_t>(bytes, media::recording_magic.size() + sizeof(uint32_t)));
  const auto tail = read_from<Tail>(bytes, bytes.size() - sizeof(Tail));
  for (uint64_t k = 0; k < tail.frames; ++k) {
    const auto entry = read_from<IndexEntry>(bytes, tail.index_offset + k * sizeof(IndexEntry));
    const char* packed = bytes.data() + entry.offset;
    std::string plain(ZSTD_getFrameContentSize(packed, entry.bytes), '\0');
    ZSTD_decompress(plain.data(), plain.size(), packed, entry.bytes);
    parts.index.push_back(entry);
    parts.frames.push_back(std::move(plain));
  }
  return parts;
}

/// Gives the bytes a tail that fits them: the checksum, and the place of the index when `place` says so.
void seal(std::string& bytes, bool place) {
  if (bytes.size() < sizeof(Tail)) return;
  const size_t end = bytes.size() - sizeof(Tail);
  auto tail = read_from<Tail>(bytes, end);
  if (place) tail.index_offset = end - tail.frames * sizeof(IndexEntry);
  bytes.resize(end);
  bytes += bytes_of(tail.index_offset);
  bytes += bytes_of(tail.frames);
  bytes += bytes_of(XXH3_64bits(bytes.data(), bytes.size()));
  bytes += bytes_of(tail.end);
}

std::string packed(const std::string& plain) {
  std::string bytes(ZSTD_compressBound(plain.size()), '\0');
  bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), plain.data(), plain.size(), 1));
  return bytes;
}

/// The index as these bytes, or made anew.
std::string put_together(const Parts& parts, const std::string* index_bytes) {
  std::string bytes = preamble(media::recording_file_kind, parts.header), index;
  for (size_t k = 0; k < parts.frames.size(); ++k) {
    const std::string block = packed(parts.frames[k]);
    index += bytes_of(IndexEntry{bytes.size(), block.size(), parts.index[k].step, parts.index[k].time});
    bytes += block;
  }
  bytes += index_bytes != nullptr ? *index_bytes : index;
  bytes += bytes_of(Tail{0, parts.frames.size(), 0, Tail().end});
  seal(bytes, true);
  return bytes;
}

void change_frame(Parts& parts, Dice& dice, std::span<const std::string> files) {
  std::string& frame = parts.frames[dice.below(parts.frames.size())];
  if (dice.one_in(2)) return dice.of(byte_mutations())(frame, dice, files);
  change_numbers(frame, dice);
}

std::string changed_part(Parts parts, Dice& dice, std::span<const std::string> files) {
  const size_t which = dice.below(3);
  if (which == 0) parts.header = changed_header(parts.header, dice);
  if (which == 1) change_frame(parts, dice, files);
  if (which < 2) return put_together(parts, nullptr);
  std::string index;
  for (const IndexEntry& entry : parts.index) index += bytes_of(entry);
  dice.of(byte_mutations())(index, dice, files);
  return put_together(parts, &index);
}

std::string mutated_recording(const std::vector<std::string>& files, Dice& dice) {
  if (dice.one_in(2)) return changed_part(taken_apart(dice.of<std::string>(files)), dice, files);
  std::string bytes = mutant(files, byte_mutations(), dice);
  if (!dice.one_in(4)) seal(bytes, dice.one_in(2));
  return bytes;
}

/// Opens a recording, looks at all of it, and says which number isn't finite. Totals may be so: the last
/// frame of a run that became invalid has those that made it so.
std::string read_recording(const std::filesystem::path& path) {
  const media::Recording recording(path);
  if (const std::string found = not_finite(recording.scene()); !found.empty()) return found;
  for (size_t k = 0; k < recording.frames(); ++k) {
    const media::Moment moment = recording.moment(k);
    const bool finite = std::isfinite(moment.report.time) && std::isfinite(moment.report.dt) &&
                        std::isfinite(moment.seconds_per_step) && is_finite(moment.state);
    if (!finite) return fmt::format("a number of frame {} is not finite", k);
  }
  return "";
}

}  // namespace

FileKind recording_kind() {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const Recorded written(folder / "a.rec", "inclined_plane", 2, precision);
    files.push_back(read_file(folder / "a.rec"));
  }
  return {"rec", [files](Dice& dice) { return mutated_recording(files, dice); }, read_recording};
}

}  // namespace sluice::test
