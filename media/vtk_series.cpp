// VTK's XML files: a head that names the arrays, then their bytes, each array behind its length.
#include "media/vtk_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/output/output_file.hpp"
#include "sluice/error.hpp"

namespace sluice::media {
namespace {

constexpr std::string_view byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

std::string file_name(uint64_t k) { return fmt::format("fluid_{:06}.vtp", k); }

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::same_as<T, int64_t>) return "Int64";
  return std::same_as<T, float> ? "Float32" : "Float64";
}

/// The binary part of a file. Arrays are declared while the head is made and written after it, in that order.
class Appended {
 public:
  /// The head's line for an array of `tuples` times K numbers; `value(i)` is tuple i as std::array<T, K>.
  template <class Value>
  std::string declare(std::string_view name, size_t tuples, Value value) {
    using Tuple = std::invoke_result_t<Value, size_t>;
    using T = typename Tuple::value_type;
    const uint64_t bytes = tuples * sizeof(Tuple);
    std::string line = fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type_name<T>(), name, std::tuple_size_v<Tuple>, offset_);
    offset_ += sizeof bytes + bytes;
    writers_.push_back([=](OutputFile& file) {
      write_bytes(file, bytes);
      for (size_t i = 0; i < tuples; ++i) write_bytes(file, value(i));
    });
    return line;
  }

  void write(OutputFile& file) const {
    for (const auto& writer : writers_) writer(file);
  }

 private:
  template <class T>
  static void write_bytes(OutputFile& file, const T& value) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    file.write({bytes.data(), bytes.size()});
  }

  uint64_t offset_ = 0;
  std::vector<std::function<void(OutputFile&)>> writers_;
};

/// Fields that are numbers of type T; vectors get a third component.
template <class T>
auto in_plane(std::span<const Vec2> values) {
  return [values](size_t i) {
    return std::array<T, 3>{static_cast<T>(values[i].x), static_cast<T>(values[i].y), T{0}};
  };
}

template <class T>
auto scalar(std::span<const double> values) {
  return [values](size_t i) { return std::array<T, 1>{static_cast<T>(values[i])}; };
}

/// 0, 1, 2, ... from `first`.
auto counting(int64_t first) {
  return [first](size_t i) { return std::array<int64_t, 1>{first + static_cast<int64_t>(i)}; };
}

std::string head(std::string_view type, std::string_view version) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"{}\" version=\"{}\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "  <{}>\n",
      type, version, byte_order, type);
}

/// Points that are drawn: each is a vertex of its own. `fields` is what stands before the piece, `data` are
/// the lines of arrays that the points carry.
template <class T>
std::string points_text(std::span<const Vec2> x, std::string_view fields, std::string_view data,
                        Appended& appended) {
  const size_t n = x.size();
  std::string text = head("PolyData", "1.0");
  text += fields;
  text += fmt::format("    <Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n      <PointData>\n", n);
  text += data;
  text += "      </PointData>\n      <Points>\n";
  text += appended.declare("Points", n, in_plane<T>(x));
  text += "      </Points>\n      <Verts>\n";
  text += appended.declare("connectivity", n, counting(0));
  text += appended.declare("offsets", n, counting(1));
  text += "      </Verts>\n    </Piece>\n  </PolyData>\n";
  return text;
}

void write_points(const std::filesystem::path& path, std::string_view text, const Appended& appended) {
  OutputFile file(path);
  file.write(text);
  file.write("  <AppendedData encoding=\"raw\">\n_");
  appended.write(file);
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

template <class T>
void write_boundary(const std::filesystem::path& path, std::span<const Vec2> x) {
  Appended appended;
  write_points(path, points_text<T>(x, "", "", appended), appended);
}

template <class T>
void write_fluid(const std::filesystem::path& path, double time, const Snapshot& state) {
  Appended appended;
  const size_t n = state.x.size();
  const std::string fields = fmt::format(
      "    <FieldData>\n      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{:.17g}</DataArray>\n    </FieldData>\n",
      time);
  std::string data = appended.declare("velocity", n, in_plane<T>(state.v));
  data += appended.declare("density", n, scalar<T>(state.density));
  data += appended.declare("pressure", n, scalar<T>(state.pressure));
  data += appended.declare("id", n, counting(0));
  write_points(path, points_text<T>(state.x, fields, data, appended), appended);
}

/// The time in a file that write_fluid made; none where there is no such file.
std::optional<double> time_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(1024, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  const size_t name = text.find("Name=\"TimeValue\""), start = text.find('>', name);
  if (name == text.npos || start == text.npos) return std::nullopt;
  double time = 0;
  const auto [rest, error] = std::from_chars(text.data() + start + 1, text.data() + text.size(), time);
  if (error != std::errc() || !std::isfinite(time)) return std::nullopt;
  return time;
}

}  // namespace

VtkSeries::VtkSeries(std::filesystem::path folder, std::span<const Vec2> boundary, Precision precision,
                     uint64_t first, double until)
    : folder_(std::move(folder)), precision_(precision), has_boundary_(!boundary.empty()), first_(first) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw EnvironmentError(fmt::format("{}: the folder can't be created: {}; choose another",
                                       folder_.string(), error.message()));
  }
  for (uint64_t k = 0; k < first_; ++k) {
    if (const auto time = time_in(folder_ / file_name(k)); time && *time <= until)
      earlier_.emplace_back(k, *time);
  }
  if (!has_boundary_) return;
  const auto write = precision == Precision::single_ ? write_boundary<float> : write_boundary<double>;
  write(folder_ / "boundary.vtp", boundary);
}

void VtkSeries::add(double time, const Snapshot& state) {
  if (finished_) throw Error(fmt::format("{}: added to after it was finished", folder_.string()));
  const auto write = precision_ == Precision::single_ ? write_fluid<float> : write_fluid<double>;
  write(folder_ / file_name(first_ + count()), time, state);
  times_.push_back(time);
}

void VtkSeries::finish() {
  if (finished_) return;
  std::string text = head("Collection", "1.0");
  const auto list = [&](uint64_t k, double time) {
    constexpr const char* line = "    <DataSet timestep=\"{:.17g}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n";
    text += fmt::format(line, time, 0, "fluid", file_name(k));
    if (has_boundary_) text += fmt::format(line, time, 1, "boundary", "boundary.vtp");
  };
  for (const auto& [k, time] : earlier_) list(k, time);
  for (size_t k = 0; k < times_.size(); ++k) list(first_ + k, times_[k]);
  text += "  </Collection>\n</VTKFile>\n";
  write_file(folder_ / "fluid.pvd", text);
  finished_ = true;
}

uint64_t VtkSeries::older_files() const {
  uint64_t older = 0;
  for (uint64_t k = first_ + count(); std::filesystem::exists(folder_ / file_name(k)); ++k) ++older;
  return older;
}

}  // namespace sluice::media
