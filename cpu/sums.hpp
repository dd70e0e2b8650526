// Sums over the neighbours of particles side by side, as many as fit into a register: every particle's in the
// order of its own list, with the bits that one particle at a time would give.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "cpu/lanes.hpp"
#include "cpu/state.hpp"

namespace sluice::cpu {

/// Particles side by side; gives their values of a field.
template <class Real>
struct Particles {
  std::array<uint32_t, lane_count<Real>> at;

  Vector<Real> operator()(const std::vector<Real>& field) const { return gather(field.data(), at.data()); }
  Pair<Vector<Real>> operator()(const std::vector<glm::vec<2, Real>>& field) const {
    return gather(field.data(), at.data());
  }
};

/// The `lanes` particles from `begin` on. Where there are fewer than a register holds, the last one fills it
/// up.
template <class Real>
Particles<Real> particles_from(uint32_t begin, uint32_t lanes) {
  Particles<Real> particles;
  for (uint32_t l = 0; l < lane_count<Real>; ++l) particles.at[l] = begin + std::min(l, lanes - 1);
  return particles;
}

/// Says of every lane that its value counts.
struct Everyone {};

/// The values that count, and 0 for the others.
template <class Value>
Value those(Everyone, Value value) {
  return value;
}
template <class There, class Value>
Value those(There there, Value value) {
  return there ? value : Value{};
}

/// Walks over the lists of the `lanes` particles from `begin` on: calls visit(block, j, there) for their
/// first neighbours j, their second ones and so on. `block` is where the x components of the gradients stand.
/// `there` is for those(): where a list has ended, j is a particle, but none to count.
template <class Real, class Visit>
[[gnu::always_inline]] inline void walk(const State<Real>& state, uint32_t begin, uint32_t lanes,
                                        const Visit& visit) {
  constexpr uint32_t width = lane_count<Real>;
  std::array<uint32_t, width> length{};
  Mask<Real> lengths{};
  for (uint32_t l = 0; l < lanes; ++l) {
    length[l] = state.list[begin + l].y;
    lengths[l] = static_cast<MaskElement<Real>>(length[l]);
  }
  const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
  const uint64_t first = state.list[begin].x;
  const uint32_t* index = state.index.data() + first;
  uint64_t block = 2 * first - first % slice_width;
  Particles<Real> j;
  uint32_t k = 0;
  for (; k < *shortest; ++k, index += slice_width, block += 2 * slice_width) {
    for (uint32_t l = 0; l < width; ++l) j.at[l] = index[l];
    visit(block, j, Everyone{});
  }
  // Where a list has ended, its entries may hold anything.
  for (; k < *longest; ++k, index += slice_width, block += 2 * slice_width) {
    for (uint32_t l = 0; l < width; ++l) {
      const uint32_t kept = 0u - uint32_t{k < length[l]};  // no branch: nobody foresees where a list ends
      j.at[l] = (index[l] & kept) | (begin & ~kept);
    }
    visit(block, j, lengths > static_cast<MaskElement<Real>>(k));
  }
}

/// Calls f(begin, lanes) for all particles, as many at a time as fit into a register.
template <class Real, class F>
void for_each_group(const State<Real>& state, F&& f) {
  constexpr uint32_t width = lane_count<Real>;
  const uint32_t n = state.params.n;
  for_each_index((uint64_t{n} + width - 1) / width, state.threads,
                 [&](uint32_t group) { f(group * width, std::min(width, n - group * width)); });
}

/// The sums of what term(i, j, dW) gives over the neighbours of the `lanes` particles from `begin` on, with
/// `start` added before.
template <class Real, size_t count, class Term>
std::array<Vector<Real>, count> sums_of(const State<Real>& state, uint32_t begin, uint32_t lanes,
                                        const std::array<Real, count>& start, const Term& term) {
  const auto i = particles_from<Real>(begin, lanes);
  const Real* gradient = state.gradient.data();
  std::array<Vector<Real>, count> sums;
  for (size_t c = 0; c < count; ++c) sums[c] = broadcast(start[c]);
  walk(state, begin, lanes, [&](uint64_t block, const Particles<Real>& j, auto there) {
    const Pair<Vector<Real>> dW{load(gradient + block), load(gradient + block + slice_width)};
    const auto terms = term(i, j, dW);
    for (size_t c = 0; c < count; ++c) sums[c] += those(there, terms[c]);
  });
  return sums;
}

/// Calls finish(i, sums) for every particle i, with the sums of what term(i, j, dW) gives for its neighbours:
/// an array of values, as many as `start` has. The term's i and j are Particles, i(state.q) their values of
/// q.
template <class Real, size_t count, class Term, class Finish>
void sum_over_neighbours(const State<Real>& state, const std::array<Real, count>& start, const Term& term,
                         const Finish& finish) {
  for_each_group(state, [&](uint32_t begin, uint32_t lanes) {
    const auto sums = sums_of(state, begin, lanes, start, term);
    for (uint32_t l = 0; l < lanes; ++l) {
      std::array<Real, count> own;
      for (size_t c = 0; c < count; ++c) own[c] = sums[c][l];
      finish(begin + l, own);
    }
  });
}

}  // namespace sluice::cpu
