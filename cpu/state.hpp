// What the CPU stages work on: constants and fields.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/model/fields.hpp"
#include "core/model/params.hpp"
#include "core/model/stages.hpp"

namespace sluice::cpu {

template <class Real, Type type>
struct ElementOf;
template <class Real>
struct ElementOf<Real, Type::real> {
  using element = Real;
};
template <class Real>
struct ElementOf<Real, Type::vec2> {
  using element = glm::vec<2, Real>;
};
template <class Real>
struct ElementOf<Real, Type::vec4> {
  using element = glm::vec<4, Real>;
};
template <class Real>
struct ElementOf<Real, Type::uint> {
  using element = uint32_t;
};
template <class Real>
struct ElementOf<Real, Type::uvec2> {
  using element = glm::uvec2;
};

/// Particles first to last - 1.
struct Range {
  size_t first, last;
};

/// The share of `thread` when `threads` divide `n` particles; it begins with a slice of the neighbour list.
inline Range share_of(size_t n, int thread, int threads) {
  const size_t chunks = (n + chunk_width - 1) / chunk_width;
  const auto begin = [&](int t) {
    return std::min(n, chunks * static_cast<size_t>(t) / static_cast<size_t>(threads) * chunk_width);
  };
  return {begin(thread), begin(thread + 1)};
}

template <class Real>
struct State {
  using Vec = glm::vec<2, Real>;

  ParamsOf<Real> params;
  Needs needs;
  Sizes sizes;
  int threads = 1;  ///< the same for every stage: changing the size of a team costs more than a small stage
  size_t reach = any_reach;  ///< numbers of neighbours differ by no more; `neighbours` finds it
  static constexpr size_t any_reach = ~uint32_t{0};
  /// Entries of the neighbour list that each thread's part needed last, and room to count them anew: of the
  /// search in cpu/simd.
  std::vector<uint64_t> part_needs{}, found_needs{};

#define FIELD(name, type, length, need, unit, meaning) \
  std::vector<typename ElementOf<Real, Type::type>::element> name;
  SLUICE_FIELDS(FIELD)
#undef FIELD
};

}  // namespace sluice::cpu
