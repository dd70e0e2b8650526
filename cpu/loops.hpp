// The ways of walking over particles, chunks of them, and rows of cells.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Calls f(i) for all i < n on `threads` threads. Who runs which i does not matter, nor in which order: f
/// writes only what belongs to i.
template <class F>
void for_each_index(uint64_t n, int threads, F&& f) {
#pragma omp parallel for simd num_threads(threads) schedule(static)
  for (size_t i = 0; i < n; ++i) f(i);
}

/// Calls f(part) for every thread's share of the particles.
template <class Real, class F>
void for_each_part(const State<Real>& state, F&& f) {
  const size_t n = state.params.n;
#pragma omp parallel for num_threads(state.threads) schedule(static)
  for (int thread = 0; thread < state.threads; ++thread) f(share_of(n, thread, state.threads));
}

/// Calls f(chunk, first, last) for all chunks of `n` particles; the chunk's are first to last - 1.
template <class F>
void for_each_chunk(uint32_t n, int threads, F&& f) {
  const auto call = [&](size_t chunk) {
    f(chunk, chunk * chunk_width, std::min<size_t>((chunk + 1) * chunk_width, n));
  };
  for_each_index((uint64_t{n} + chunk_width - 1) / chunk_width, threads, call);
}

/// Calls f(first, last) for the three ranges of places in L, one per row of cells, that hold all particles in
/// reach of a position in `cell`; `C` gives the first place of each cell.
template <class F>
void for_each_row(const std::vector<uint32_t>& C, uint32_t columns, uint32_t cell, F&& f) {
  for (const uint32_t middle : {cell - columns, cell, cell + columns}) f(C[middle - 1], C[middle + 2]);
}

}  // namespace sluice::cpu::SLUICE_SET
