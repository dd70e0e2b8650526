// Which particles are the neighbours of one: 16 candidates at a time are compared and kept or not without a
// branch, since a processor could not foresee which. Two ways, one for every processor and one for AVX-512,
// with the same results.
#pragma once

#include <algorithm>
#include <array>

#include "cpu/lanes.hpp"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace sluice::cpu {

/// The candidates for neighbours of particle i: three ranges of places, first to last - 1.
struct Candidates {
  uint32_t i;
  std::array<glm::uvec2, 3> rows;

  uint64_t count() const {
    uint64_t sum = 0;
    for (const glm::uvec2 row : rows) sum += row.y - row.x;
    return sum;
  }
};

inline constexpr uint32_t block_width = 16;

/// Those of the 16 particles from `block` on that are in first to last - 1 and not i, as bits.
inline uint32_t members(uint32_t block, uint32_t first, uint32_t last, uint32_t i) {
  const uint32_t in_range = (1u << std::min(last - block, block_width)) - (1u << (first - block));
  return in_range & ~(i - block < block_width ? 1u << (i - block) : 0u);
}

/// For each set of four, as bits: its members in order, and their number.
struct Choice {
  uint32_t members[16][4];
  uint32_t size[16];
};
inline constexpr Choice choice = [] {
  Choice result{};
  for (uint32_t bits = 0; bits < 16; ++bits) {
    for (uint32_t k = 0; k < 4; ++k) {
      if ((bits >> k & 1) != 0) result.members[bits][result.size[bits]++] = k;
    }
  }
  return result;
}();

/// Which of the four positions from x on are nearer to x_i than the support, as bits.
template <class Real>
uint32_t near_of_4(const glm::vec<2, Real>* x, Pair<Vector<Real>> x_i, Real support_squared) {
  uint32_t bits = 0;
  for (uint32_t k = 0; k < 4; k += lane_count<Real>) {
    const auto x_ij = x_i - load_pairs(x + k);
    bits |= bits_of(dot(x_ij, x_ij) < support_squared) << k;
  }
  return bits;
}

/// Writes the neighbours among the candidates to `found`, which has room for all of them and one block more,
/// and returns their number. There are n positions x, at least a block.
template <class Real>
uint32_t find_4_wide(const glm::vec<2, Real>* x, uint32_t n, Real support_squared,
                     const Candidates& candidates, uint32_t* found) {
  const glm::vec<2, Real> x_i = x[candidates.i];
  const Pair<Vector<Real>> here{broadcast(x_i.x), broadcast(x_i.y)};
  uint32_t count = 0;
  for (const glm::uvec2 row : candidates.rows) {
    for (uint32_t first = row.x; first < row.y; first += block_width) {
      const uint32_t block = std::min(first, n - block_width);
      const uint32_t wanted = members(block, first, row.y, candidates.i);
#pragma GCC unroll 4
      for (uint32_t k = 0; k < block_width; k += 4) {
        const uint32_t bits = wanted >> k & near_of_4(x + block + k, here, support_squared);
        const Vector<uint32_t> j = load(choice.members[bits]) + (block + k);
        std::memcpy(found + count, &j, sizeof j);
        count += choice.size[bits];
      }
    }
  }
  return count;
}

#ifdef __x86_64__
#define SLUICE_AVX512 [[gnu::target("avx512f")]]

SLUICE_AVX512 inline uint32_t near_of_16(const glm::vec2* x, glm::vec2 x_i, float support_squared) {
  const __m512i even = _mm512_set_epi32(30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0);
  const __m512 a = _mm512_loadu_ps(x), b = _mm512_loadu_ps(x + 8);
  const __m512i odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
  const __m512 dx = _mm512_sub_ps(_mm512_set1_ps(x_i.x), _mm512_permutex2var_ps(a, even, b));
  const __m512 dy = _mm512_sub_ps(_mm512_set1_ps(x_i.y), _mm512_permutex2var_ps(a, odd, b));
  const __m512 r_squared = _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy));
  return _mm512_cmp_ps_mask(r_squared, _mm512_set1_ps(support_squared), _CMP_LT_OQ);
}

SLUICE_AVX512 inline uint32_t near_of_8(const glm::dvec2* x, glm::dvec2 x_i, double support_squared) {
  const __m512d a = _mm512_loadu_pd(x), b = _mm512_loadu_pd(x + 4);
  const __m512i even = _mm512_set_epi64(14, 12, 10, 8, 6, 4, 2, 0);
  const __m512i odd = _mm512_add_epi64(even, _mm512_set1_epi64(1));
  const __m512d dx = _mm512_sub_pd(_mm512_set1_pd(x_i.x), _mm512_permutex2var_pd(a, even, b));
  const __m512d dy = _mm512_sub_pd(_mm512_set1_pd(x_i.y), _mm512_permutex2var_pd(a, odd, b));
  const __m512d r_squared = _mm512_add_pd(_mm512_mul_pd(dx, dx), _mm512_mul_pd(dy, dy));
  return _mm512_cmp_pd_mask(r_squared, _mm512_set1_pd(support_squared), _CMP_LT_OQ);
}
SLUICE_AVX512 inline uint32_t near_of_16(const glm::dvec2* x, glm::dvec2 x_i, double support_squared) {
  return near_of_8(x, x_i, support_squared) | near_of_8(x + 8, x_i, support_squared) << 8;
}

/// What find_4_wide does, for a processor with AVX-512.
template <class Real>
SLUICE_AVX512 uint32_t find_16_wide(const glm::vec<2, Real>* x, uint32_t n, Real support_squared,
                                    const Candidates& candidates, uint32_t* found) {
  const glm::vec<2, Real> x_i = x[candidates.i];
  const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  uint32_t count = 0;
  for (const glm::uvec2 row : candidates.rows) {
    for (uint32_t first = row.x; first < row.y; first += block_width) {
      const uint32_t block = std::min(first, n - block_width);
      const uint32_t bits =
          members(block, first, row.y, candidates.i) & near_of_16(x + block, x_i, support_squared);
      const __m512i j = _mm512_add_epi32(lanes, _mm512_set1_epi32(static_cast<int>(block)));
      _mm512_storeu_si512(found + count, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), j));
      count += static_cast<uint32_t>(__builtin_popcount(bits));
    }
  }
  return count;
}
#endif

template <class Real>
using Find = uint32_t (*)(const glm::vec<2, Real>* x, uint32_t n, Real support_squared,
                          const Candidates& candidates, uint32_t* found);

/// The fastest way on this processor.
template <class Real>
Find<Real> fastest_find() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return find_16_wide<Real>;
#endif
  return find_4_wide<Real>;
}

}  // namespace sluice::cpu
