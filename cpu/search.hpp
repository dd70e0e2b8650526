// Which particles are the neighbours of one: 16 candidates at a time are compared and kept or not without a
// branch, since a processor could not foresee which.
#pragma once

#include "cpu/lanes.hpp"

namespace sluice::cpu::SLUICE_SET {

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

/// Which of the 16 positions from x on are nearer to x_i than the support, as bits.
template <class Real>
uint32_t near_of_block(const glm::vec<2, Real>* x, Pair<Vector<Real>> x_i, Real support_squared) {
  uint32_t bits = 0;
  for (uint32_t k = 0; k < block_width; k += lane_count<Real>) {
    const auto x_ij = x_i - load(x + k);
    bits |= bits_below(dot(x_ij, x_ij), support_squared) << k;
  }
  return bits;
}

#if SLUICE_VECTOR_BYTES == 64

/// Writes those of the 16 numbers from `first` on that `bits` has to `found`, and as many others as make 16;
/// returns how many those are.
inline uint32_t keep(uint32_t bits, uint32_t first, uint32_t* found) {
  const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i j = _mm512_add_epi32(lanes, _mm512_set1_epi32(static_cast<int>(first)));
  _mm512_storeu_si512(found, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), j));
  return static_cast<uint32_t>(std::popcount(bits));
}

#else

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

/// Writes those of the 16 numbers from `first` on that `bits` has to `found`, and others after them; returns
/// how many those are.
inline uint32_t keep(uint32_t bits, uint32_t first, uint32_t* found) {
  uint32_t count = 0;
#pragma GCC unroll 4
  for (uint32_t k = 0; k < block_width; k += 4) {
    const uint32_t four = bits >> k & 15;
    for (uint32_t c = 0; c < 4; ++c) found[count + c] = choice.members[four][c] + first + k;
    count += choice.size[four];
  }
  return count;
}

#endif

/// Writes the neighbours among the candidates to `found`, which has room for all of them and one block more,
/// and returns their number. There are n positions x, at least a block.
template <class Real>
uint32_t find(const glm::vec<2, Real>* x, uint32_t n, Real support_squared, const Candidates& candidates,
              uint32_t* found) {
  const glm::vec<2, Real> x_i = x[candidates.i];
  const Pair<Vector<Real>> here{broadcast(x_i.x), broadcast(x_i.y)};
  uint32_t count = 0;
  for (const glm::uvec2 row : candidates.rows) {
    for (uint32_t first = row.x; first < row.y; first += block_width) {
      const uint32_t block = std::min(first, n - block_width);
      const uint32_t near = near_of_block(x + block, here, support_squared);
      count += keep(near & members(block, first, row.y, candidates.i), block, found + count);
    }
  }
  return count;
}

}  // namespace sluice::cpu::SLUICE_SET
