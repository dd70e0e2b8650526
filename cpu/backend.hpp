// The CPU backend: OpenMP threads over plain arrays. In float it is the reference the shaders are compared
// with bit for bit, in double what errors are measured against.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/solver/backend.hpp"
#include "sluice/choices.hpp"

namespace sluice::cpu {

/// The functions that stages are run with: the plain ones of cpu/, which read like the shaders, or those of
/// cpu/simd/ for a set of instructions, where there are any. Each set includes the sets above it.
// clang-format off
#define SLUICE_INSTRUCTIONS(CHOICE)                                             \
  CHOICE(plain, "plain", "one particle at a time, as in the shaders")           \
  CHOICE(baseline, "baseline", "what every processor of this kind has")         \
  CHOICE(avx2, "avx2", "registers of 32 bytes")                                 \
  CHOICE(avx512, "avx512", "registers of 64 bytes")
SLUICE_DECLARE_CHOICES(Instructions, SLUICE_INSTRUCTIONS)
// clang-format on

/// Instructions that this processor knows and this program was built for, the widest last; `plain` is always
/// there.
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
