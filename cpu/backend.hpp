// The CPU backend: OpenMP threads over plain arrays. In float it is the reference the shaders are compared
// with bit for bit, in double what errors are measured against.
#pragma once

#include <memory>

#include "core/solver/backend.hpp"

namespace sluice::cpu {

/// What a processor may know, each beyond what stands before it.
enum class Instructions { baseline, avx2, avx512 };

/// The widest that this processor knows, and this program was built for.
Instructions widest_instructions();

/// `threads` >= 1. Results depend neither on it nor on the instructions.
std::unique_ptr<Backend> make_backend(Precision precision, int threads,
                                      Instructions instructions = widest_instructions());

/// Threads this machine runs at once.
int hardware_threads();

/// Name of the processor, for people.
std::string processor_name();

}  // namespace sluice::cpu
