// The CPU backend: OpenMP threads over plain arrays. In float it is the reference the shaders are compared
// with bit for bit, in double what errors are measured against.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/solver/backend.hpp"

namespace sluice::cpu {

/// Which functions stages are run with: the plain ones of cpu/, which read like the shaders, or where there
/// are any those of cpu/simd/ for a set of instructions, each of which knows what stands before it.
enum class Instructions { plain, baseline, avx2, avx512 };
inline constexpr std::array<std::string_view, 4> instruction_names = {"plain", "baseline", "avx2", "avx512"};
inline std::string_view name_of(Instructions instructions) {
  return instruction_names[static_cast<size_t>(instructions)];
}

/// Those that this processor knows and this program was built for, the widest last; `plain` is always there.
std::vector<Instructions> available_instructions();
Instructions widest_instructions();
/// "plain, baseline", for people.
std::string names_of(const std::vector<Instructions>& instructions);

/// `threads` >= 1. Results depend neither on it nor on the instructions, which have to be available.
std::unique_ptr<Backend> make_backend(Precision precision, int threads,
                                      Instructions instructions = widest_instructions());

/// Threads this machine runs at once.
int hardware_threads();

/// Name of the processor, for people.
std::string processor_name();

}  // namespace sluice::cpu
