// Every stage is compiled several times, once for each set of instructions that processors have: the build
// says which one with SLUICE_SET, a namespace, and SLUICE_VECTOR_BYTES. The backend takes the widest that the
// processor knows.
//
// What other files share must not be compiled for more than every processor has: the linker keeps one copy of
// an inline function, whoever made it. So all that is not ours is included here, before the set is chosen.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/model/choices.hpp"
#include "core/model/larger.hpp"
#include "cpu/state.hpp"

#ifdef __SSE2__
#include <immintrin.h>
#endif

#ifndef SLUICE_SET
#define SLUICE_SET baseline
#define SLUICE_VECTOR_BYTES 16
#endif

#if SLUICE_VECTOR_BYTES == 64
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl,bmi2,popcnt,prefer-vector-width=512")
#elif SLUICE_VECTOR_BYTES == 32
#pragma GCC target("avx2,bmi2,popcnt")
#endif

namespace sluice::cpu {
inline namespace SLUICE_SET {
inline constexpr uint32_t vector_bytes = SLUICE_VECTOR_BYTES;
}
}  // namespace sluice::cpu
