// Random numbers that are the same everywhere.
#pragma once

#include <cstdint>

namespace sluice {

/// SplitMix64 [Steele et al. 2014], written out so that a seed means the same numbers everywhere.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// Uniform in [0, 1), 53 bits.
  double uniform() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z = z ^ (z >> 31);
    return static_cast<double>(z >> 11) * 0x1p-53;
  }

 private:
  uint64_t state_;
};

}  // namespace sluice
