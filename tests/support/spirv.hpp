// SPIR-V, as much of it as tests read: the instructions of a module.
#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace sluice::test {

struct SpirvInstruction {
  uint32_t code;
  std::span<const uint32_t> operands;
};

/// A module from a file; empty when there is none.
inline std::vector<uint32_t> read_spirv(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<uint32_t> words(bytes.size() / 4);
  bytes.copy(reinterpret_cast<char*>(words.data()), 4 * words.size());
  return words;
}

inline std::vector<SpirvInstruction> instructions_of(const std::vector<uint32_t>& words) {
  constexpr size_t header = 5;
  std::vector<SpirvInstruction> all;
  for (size_t at = header; at < words.size();) {
    const size_t length = words[at] >> 16;
    if (length == 0 || at + length > words.size()) return {};
    all.push_back({words[at] & 0xffff, std::span(words).subspan(at + 1, length - 1)});
    at += length;
  }
  return all;
}

/// Number of operations on floats that a compiler may contract, as a * b + c to one operation with other
/// bits.
inline int contractable(const std::vector<SpirvInstruction>& module) {
  constexpr uint32_t decorate = 71, no_contraction = 42;
  const std::set<uint32_t> arithmetic{129, 131, 133,
                                      136, 142, 148};  // FAdd FSub FMul FDiv VectorTimesScalar Dot
  std::set<uint32_t> kept;
  int found = 0;
  for (const auto& [code, operands] : module) {
    if (code == decorate && operands[1] == no_contraction) kept.insert(operands[0]);
    if (arithmetic.contains(code) && !kept.contains(operands[1])) ++found;
  }
  return found;
}

}  // namespace sluice::test
