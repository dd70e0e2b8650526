// The choices of how the pressure system of IISPH is solved.
#pragma once

#include <cstdint>

namespace sluice {

/// How the system is iterated, what its wall term is like, and when it counts as solved.
enum class Solver : uint32_t { jacobi, barzilai_borwein };
enum class Wall { thesis, symmetric };
enum class Stop : uint32_t { density, residual };

}  // namespace sluice
