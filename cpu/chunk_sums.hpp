// What a chunk of particles adds up to, in several sums.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// One sum, from 0 on, for each name in the enum `Sum`.
template <class Real, class Sum>
class ChunkSums {
 public:
  Real& operator[](Sum sum) { return sums_[static_cast<size_t>(sum)]; }

  /// Writes them to `field`, which has all chunks' first sums, all their second ones, and so on.
  void write(std::vector<Real>& field, size_t chunk, uint64_t chunks) const {
    for (size_t sum = 0; sum < sums_.size(); ++sum) field[sum * chunks + chunk] = sums_[sum];
  }

 private:
  std::array<Real, static_cast<size_t>(Sum::count)> sums_{};
};

}  // namespace sluice::cpu::SLUICE_SET
