// A state to be written for ParaView, and the written file cut into its head and its bytes.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "sluice/report.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {

/// n particles with values that no float holds; id 1 has the numbers that are hard to keep.
inline Snapshot some_state(size_t n, double seed = 0) {
  Snapshot state;
  for (size_t i = 0; i < n; ++i) {
    const double k = static_cast<double>(i) + seed;
    state.x.emplace_back(k / 3, -k / 7);
    state.v.emplace_back(std::numbers::pi * k, -1e-3 / (k + 1));
    state.density.push_back(1000 + k / 9);
    state.pressure.push_back(1e5 / (k + 1.1));
  }
  if (n > 1) state.x[1] = {-0.0, 1e-30}, state.pressure[1] = 0;
  state.step = 3;
  return state;
}

/// The value of an attribute behind the first `tag` of the text.
inline std::string attribute(const std::string& text, const std::string& tag, const std::string& name) {
  const size_t start = text.find(tag), end = text.find('>', start);
  if (start == std::string::npos) return "no " + tag;
  const std::string element = text.substr(start, end - start), key = " " + name + "=\"";
  const size_t value = element.find(key);
  if (value == std::string::npos) return "no " + name;
  return element.substr(value + key.size(), element.find('"', value + key.size()) - value - key.size());
}

/// A file, cut into its head and its appended bytes.
struct VtkFile {
  explicit VtkFile(const std::filesystem::path& path) : VtkFile(read_file(path), 0) {}
  VtkFile(const std::string& all, int) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_", tail = "\n  </AppendedData>\n</VTKFile>\n";
    const size_t start = all.find(mark);
    if (start == std::string::npos || !all.ends_with(tail)) throw std::runtime_error("no appended data");
    head = all.substr(0, start);
    bytes = all.substr(start + mark.size(), all.size() - start - mark.size() - tail.size());
  }

  std::string of_array(const std::string& name, const std::string& key) const {
    return attribute(head, "<DataArray type=\"" + type(name) + "\" Name=\"" + name + "\"", key);
  }
  std::string type(const std::string& name) const {
    for (const std::string candidate : {"Float32", "Float64", "Int64"})
      if (head.find("<DataArray type=\"" + candidate + "\" Name=\"" + name + "\"") != std::string::npos)
        return candidate;
    return "none";
  }

  template <class T>
  T at(size_t offset) const {
    T value{};
    if (offset + sizeof(T) > bytes.size()) throw std::runtime_error("beyond the end");
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
  }

  /// The numbers of an array; marks its bytes as seen.
  template <class T>
  std::vector<T> array(const std::string& name) {
    const size_t offset = std::stoul(of_array(name, "offset"));
    const uint64_t length = at<uint64_t>(offset);
    EXPECT_EQ(length % sizeof(T), 0u) << name;
    std::vector<T> values;
    for (size_t k = 0; k < length; k += sizeof(T)) values.push_back(at<T>(offset + 8 + k));
    seen[offset] = offset + 8 + length;
    return values;
  }

  /// Whether the arrays that were read fill the appended bytes without gaps.
  bool gapless() const {
    size_t end = 0;
    for (const auto& [first, behind] : seen) {
      if (first != end) return false;
      end = behind;
    }
    return end == bytes.size();
  }

  std::string head, bytes;
  std::map<size_t, size_t> seen;
};

}  // namespace sluice::test
