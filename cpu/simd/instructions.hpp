// The set of instructions that a file of cpu/simd/ is compiled for: the build says which one with SLUICE_SET,
// a namespace, and SLUICE_VECTOR_BYTES. Every file here includes this first.
//
// What other files share must not be compiled for more than every processor has: the linker keeps one copy of
// an inline function, whoever made it. So all that is not ours is included here, before the set is chosen.
#pragma once

#ifndef SLUICE_SET
#define SLUICE_SET baseline
#endif
#ifndef SLUICE_VECTOR_BYTES
#define SLUICE_VECTOR_BYTES 16
#endif

#include <concepts>
#include <cstring>
#include <type_traits>
#include <utility>

#include "cpu/instructions.hpp"
#include "cpu/simd/part.hpp"

#ifdef __SSE2__
#include <immintrin.h>
#endif

#if SLUICE_VECTOR_BYTES == 64
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl,bmi2,popcnt,prefer-vector-width=512")
#elif SLUICE_VECTOR_BYTES == 32
#pragma GCC target("avx2,bmi2,popcnt")
#endif

namespace sluice::cpu::SLUICE_SET {
inline constexpr uint32_t vector_bytes = SLUICE_VECTOR_BYTES;
}
