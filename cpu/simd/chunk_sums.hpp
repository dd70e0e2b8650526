// Sums per chunk of particles: what each particle has a share in is computed side by side, and then added up
// particle by particle, since the order decides the bits.
#pragma once

#include "cpu/fold.hpp"
#include "cpu/simd/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Shares of the particles of a chunk in each of `count` totals.
template <class Real, uint32_t count>
class Shares {
 public:
  /// Shares of the particles from `place` of the chunk on.
  void set(auto total, size_t place, Vector<Real> values) {
    store(values, &of_[static_cast<size_t>(total)][place]);
  }
  Real at(uint32_t total, size_t place) const { return of_[total][place]; }

 private:
  Real of_[count][chunk_width]{};
};

/// Calls share(i, place, shares) for the particles i of every chunk, and writes to `sums` what add(total,
/// sum, share) makes of them, from 0 on: all chunks' first totals, all their second ones, and so on.
template <uint32_t count, class Real, class Share, class Add>
void sum_over_chunks(const State<Real>& state, std::vector<Real>& sums, const Share& share, const Add& add) {
  const uint64_t chunks = state.sizes.chunks();
  for_each_chunk(state.params.n, state.threads, [&](size_t chunk, size_t first, size_t last) {
    Shares<Real, count> shares;
    for_each_group<Real>(Range{first, last}, [&](const auto& i) { share(i, i.first - first, shares); });
    Real totals[count]{};
    for (size_t k = 0; k < last - first; ++k) {
      for (uint32_t total = 0; total < count; ++total)
        totals[total] = add(total, totals[total], shares.at(total, k));
    }
    for (uint32_t total = 0; total < count; ++total) sums[total * chunks + chunk] = totals[total];
  });
}

}  // namespace sluice::cpu::SLUICE_SET
