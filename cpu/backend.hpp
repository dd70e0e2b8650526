// The CPU backend: OpenMP threads over plain arrays. In float it is the reference the shaders are compared
// with bit for bit, in double what errors are measured against.
#pragma once

#include <memory>

#include "core/backend.hpp"

namespace sluice::cpu {

/// `threads` >= 1. Results do not depend on it.
std::unique_ptr<Backend> make_backend(Precision precision, int threads);

/// Threads this machine runs at once.
int hardware_threads();

/// Name of the processor, for people.
std::string processor_name();

}  // namespace sluice::cpu
