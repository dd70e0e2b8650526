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

/// The sums of what term(i, j, dW) gives over the neighbours of the `lanes` particles from `begin` on, with
/// `start` added before.
template <class Real, size_t count, class Term>
std::array<Vector<Real>, count> sums_of(const State<Real>& state, uint32_t begin, uint32_t lanes,
                                        const std::array<Real, count>& start, const Term& term) {
  constexpr uint32_t width = lane_count<Real>;
  Particles<Real> i, j;
  std::array<uint32_t, width> length{};
  Mask<Real> lengths{};
  for (uint32_t l = 0; l < width; ++l) i.at[l] = begin + std::min(l, lanes - 1);
  for (uint32_t l = 0; l < lanes; ++l) {
    length[l] = state.list[begin + l].y;
    lengths[l] = static_cast<MaskElement<Real>>(length[l]);
  }
  const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
  const uint64_t first = state.list[begin].x;
  const uint32_t* index = state.index.data() + first;
  const Real* gradient = state.gradient.data() + 2 * first - first % slice_width;
  const auto next_terms = [&] {
    const Pair<Vector<Real>> dW{load(gradient), load(gradient + slice_width)};
    index += slice_width;
    gradient += 2 * slice_width;
    return term(i, j, dW);
  };

  std::array<Vector<Real>, count> sums;
  for (size_t c = 0; c < count; ++c) sums[c] = broadcast(start[c]);
  uint32_t k = 0;
  for (; k < *shortest; ++k) {
    for (uint32_t l = 0; l < width; ++l) j.at[l] = index[l];
    const auto terms = next_terms();
    for (size_t c = 0; c < count; ++c) sums[c] += terms[c];
  }
  // Where a list has ended, its entries may hold anything.
  for (; k < *longest; ++k) {
    for (uint32_t l = 0; l < width; ++l) j.at[l] = k < length[l] ? index[l] : begin;
    const auto terms = next_terms();
    const Mask<Real> there = lengths > static_cast<MaskElement<Real>>(k);
    for (size_t c = 0; c < count; ++c) sums[c] += there ? terms[c] : Vector<Real>{};
  }
  return sums;
}

/// Calls finish(i, sums) for every particle i, with the sums of what term(i, j, dW) gives for its neighbours:
/// an array of values, as many as `start` has. The term's i and j are Particles, i(state.q) their values of
/// q.
template <class Real, size_t count, class Term, class Finish>
void sum_over_neighbours(const State<Real>& state, const std::array<Real, count>& start, const Term& term,
                         const Finish& finish) {
  constexpr uint32_t width = lane_count<Real>;
  const uint32_t n = state.params.n;
  for_each_index((uint64_t{n} + width - 1) / width, state.threads, [&](uint32_t group) {
    const uint32_t begin = group * width, lanes = std::min(width, n - begin);
    const auto sums = sums_of(state, begin, lanes, start, term);
    for (uint32_t l = 0; l < lanes; ++l) {
      std::array<Real, count> own;
      for (size_t c = 0; c < count; ++c) own[c] = sums[c][l];
      finish(begin + l, own);
    }
  });
}

}  // namespace sluice::cpu
