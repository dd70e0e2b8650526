// Which particles are the neighbours of one: a block of candidates at a time is compared and kept or not
// without a branch, since a processor could not foresee which. Particles of one cell share their candidates.
#pragma once

#include "cpu/loops.hpp"
#include "cpu/simd/lanes.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Candidates that are compared at a time, and kept in one go.
template <class Real>
inline constexpr uint32_t block_width = vector_bytes == 64 ? 16 : std::max(4u, lane_count<Real>);

/// Candidates per particle up to which they are put aside; where more of them crowd, they are searched one by
/// one.
inline constexpr uint32_t most_candidates = 480;

/// Room for the neighbours of one particle, and for a block more.
using Neighbours = std::array<uint32_t, most_candidates + 16>;

/// Particles that follow each other, some of them candidates.
template <class Real>
struct Block {
  std::array<Pair<Vector<Real>>, block_width<Real> / lane_count<Real>> x;
  uint32_t first;
  uint32_t members;  ///< the candidates among them, as bits
};

/// What the particles of a cell have in common.
template <class Real>
struct Cell {
  uint32_t place = ~0u;  ///< of the cell in the grid
  uint32_t reach = 0;    ///< numbers of the cell's particles and of their candidates differ by no more
  bool crowded = false;  ///< there are too many candidates; `blocks` has none
  uint32_t own_first = 0, own_block = 0;  ///< first candidate of the cell's own row, and its block
  uint32_t count = 0;
  std::array<Block<Real>, most_candidates / block_width<Real> + 3> blocks;
};

/// Appends the particles first to last - 1 to the candidates.
template <class Real>
void append(const std::vector<glm::vec<2, Real>>& x, uint32_t first, uint32_t last, Cell<Real>& cell) {
  constexpr uint32_t width = block_width<Real>;
  const uint32_t last_block = static_cast<uint32_t>(x.size()) - width;
  for (; first < last; first += width) {
    Block<Real>& block = cell.blocks[cell.count++];
    block.first = std::min(first, last_block);
    block.members = (1u << std::min(last - block.first, width)) - (1u << (first - block.first));
    for (uint32_t k = 0; k < block.x.size(); ++k) block.x[k] = load(&x[block.first + k * lane_count<Real>]);
  }
}

/// Makes the particles of three ranges the candidates, unless they are too many.
template <class Real>
void set_candidates(const std::vector<glm::vec<2, Real>>& x, const std::array<glm::uvec2, 3>& rows,
                    Cell<Real>& cell) {
  uint64_t candidates = 0;
  for (const glm::uvec2 row : rows) candidates += row.y - row.x;
  cell.crowded = candidates > most_candidates || x.size() < block_width<Real>;
  cell.count = 0;
  if (cell.crowded) return;
  append(x, rows[0].x, rows[0].y, cell);
  cell.own_first = rows[1].x;
  cell.own_block = cell.count;
  append(x, rows[1].x, rows[1].y, cell);
  append(x, rows[2].x, rows[2].y, cell);
}

/// Sets `cell` to the one at `place` in the grid.
template <class Real>
void enter(const State<Real>& state, uint32_t place, Cell<Real>& cell) {
  std::array<glm::uvec2, 3> rows;
  uint32_t row = 0;
  for_each_row(state.C, state.params.columns, place, [&](uint32_t first, uint32_t last) {
    rows[row++] = {first, last};
  });
  cell.place = place;
  cell.reach = std::max(state.C[place + 1] - 1 - rows.front().x, rows.back().y - state.C[place]);
  set_candidates(state.x, rows, cell);
}

/// Which particles of a block are nearer to x_i than the support, as bits.
template <class Real>
uint32_t near_of(const Block<Real>& block, const Pair<Vector<Real>>& x_i, Real support_squared) {
  uint32_t bits = 0;
  for (uint32_t k = 0; k < block.x.size(); ++k) {
    const auto x_ij = x_i - block.x[k];
    bits |= bits_below(dot(x_ij, x_ij), support_squared) << (k * lane_count<Real>);
  }
  return bits;
}

#if SLUICE_VECTOR_BYTES == 64

/// Writes those of the `width` numbers from `first` on that `bits` has to `found`, and as many others as make
/// a block; returns how many those are.
template <uint32_t width>
uint32_t keep(uint32_t bits, uint32_t first, uint32_t* found) {
  const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i j = _mm512_add_epi32(lanes, _mm512_set1_epi32(static_cast<int>(first)));
  _mm512_storeu_si512(found, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), j));
  return static_cast<uint32_t>(std::popcount(bits));
}

#else

/// For each set of numbers below `width`, as bits: its members in order, and their number.
template <uint32_t width>
struct Choice {
  uint32_t members[1 << width][width];
  uint32_t size[1 << width];
};
template <uint32_t width>
inline constexpr Choice<width> choice = [] {
  Choice<width> result{};
  for (uint32_t bits = 0; bits < 1u << width; ++bits) {
    for (uint32_t k = 0; k < width; ++k) {
      if ((bits >> k & 1) != 0) result.members[bits][result.size[bits]++] = k;
    }
  }
  return result;
}();

/// Writes those of the `width` numbers from `first` on that `bits` has to `found`, and as many others as make
/// a block; returns how many those are.
template <uint32_t width>
uint32_t keep(uint32_t bits, uint32_t first, uint32_t* found) {
  using Numbers = typename VectorOf<uint32_t, width>::type;
  store(load_as<Numbers>(choice<width>.members[bits]) + first, found);
  return choice<width>.size[bits];
}

#endif

/// Writes the neighbours of particle i, which is in the middle one of the ranges, to `found`, and returns
/// their number.
template <class Real>
uint32_t find(Cell<Real>& cell, uint32_t i, glm::vec<2, Real> x_i, Real support_squared, Neighbours& found) {
  const Pair<Vector<Real>> here{broadcast(x_i.x), broadcast(x_i.y)};
  Block<Real>& own = cell.blocks[cell.own_block + (i - cell.own_first) / block_width<Real>];
  const uint32_t others = own.members, itself = 1u << (i - own.first);
  own.members = others & ~itself;
  uint32_t count = 0;
  for (uint32_t b = 0; b < cell.count; ++b) {
    const Block<Real>& block = cell.blocks[b];
    const uint32_t bits = near_of(block, here, support_squared) & block.members;
    count += keep<block_width<Real>>(bits, block.first, &found[count]);
  }
  own.members = others;
  return count;
}

}  // namespace sluice::cpu::SLUICE_SET
