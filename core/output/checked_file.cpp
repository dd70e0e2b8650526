// Reading in parts, and what is said of a file that is not what was written.
#include "core/output/checked_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/output/summary.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/version.hpp"

namespace sluice {
namespace {

constexpr uint64_t part = uint64_t{1} << 20;  // bytes read at a time for the checksum

}  // namespace

struct Checksum::State {
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash{XXH3_createState(), &XXH3_freeState};
};

Checksum::Checksum() : state_(std::make_unique<State>()) {
  if (!state_->hash || XXH3_64bits_reset(state_->hash.get()) == XXH_ERROR)
    throw EnvironmentError("no memory for the checksum of a file; close other programs");
}
Checksum::~Checksum() = default;
Checksum::Checksum(Checksum&&) noexcept = default;

void Checksum::add(std::string_view bytes) {
  XXH3_64bits_update(state_->hash.get(), bytes.data(), bytes.size());
}

uint64_t Checksum::value() const { return XXH3_64bits_digest(state_->hash.get()); }

std::string run_header(const Scene& scene, Precision precision, const std::string& device) {
  const nlohmann::ordered_json json = {{"version", version()},
                                       {"precision", name_of(precision)},
                                       {"device", device},
                                       {"file", std::filesystem::path(scene.file).filename().string()},
                                       {"overrides", scene.record.overrides},
                                       {"text", scene.record.text}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string preamble(const FileKind& kind, std::string_view header) {
  std::string text(kind.magic);
  text += bytes_of(kind.format);
  text += bytes_of(static_cast<uint32_t>(header.size()));
  text += header;
  return text;
}

CheckedFile::CheckedFile(std::filesystem::path path, const FileKind& kind)
    : path_(std::move(path)), kind_(kind) {
  std::error_code error;
  size_ = std::filesystem::file_size(path_, error);
  if (std::filesystem::is_directory(path_, error))
    refuse(fmt::format("found a folder, expected a {}", kind_.name));
  if (!std::filesystem::exists(path_, error))
    refuse(fmt::format("found no such file, expected a {}", kind_.name));
  // Opening a pipe would wait for somebody to write to it.
  if (std::filesystem::is_regular_file(path_, error)) file_.open(path_, std::ios::binary);
  if (!file_.is_open() || !file_ || size_ == no_size)
    refuse(fmt::format("found a file that can't be read, expected a {}", kind_.name));
}

std::string CheckedFile::read(uint64_t offset, uint64_t bytes) {
  if (bytes > size_ || offset > size_ - bytes) refuse_altered();
  std::string text(bytes, '\0');
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset));
  file_.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<uint64_t>(file_.gcount()) != bytes) refuse_altered();
  return text;
}

uint32_t CheckedFile::read_preamble() {
  const std::string start = read(0, std::min<uint64_t>(size_, header_offset()));
  if (!start.starts_with(kind_.magic)) {
    if (start.size() >= kind_.magic.size() || !kind_.magic.starts_with(start))
      refuse(fmt::format("found another kind of file, expected a {} made by {}", kind_.name, kind_.made_by));
    refuse_altered();
  }
  if (start.size() < header_offset()) refuse_altered();
  const auto found = read_from<uint32_t>(start, kind_.magic.size());
  if (found != kind_.format) {
    refuse(
        fmt::format("found a {0} of format {1}, expected format {2}; use the version of Sluice that made it",
                    kind_.name, found, kind_.format));
  }
  return read_from<uint32_t>(start, kind_.magic.size() + sizeof(uint32_t));
}

uint64_t CheckedFile::checksum(uint64_t bytes) {
  Checksum sum;
  for (uint64_t at = 0; at < bytes; at += part) sum.add(read(at, std::min(part, bytes - at)));
  return sum.value();
}

void CheckedFile::refuse(const std::string& what) const {
  throw InputError(fmt::format("{}: {}", path_.string(), what));
}

void CheckedFile::refuse_altered() const {
  refuse(fmt::format("found a {} that was cut off or altered, expected one as {} wrote it; {}", kind_.name,
                     kind_.made_by, kind_.advice));
}

}  // namespace sluice
