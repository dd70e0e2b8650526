// Sums over the neighbours of particles side by side, as many as fit into a register: every particle's in the
// order of its own list, with the bits that one particle at a time would give.
#pragma once

#include "cpu/loops.hpp"
#include "cpu/simd/lanes.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Any particles side by side; gives their values of a field.
template <class Real>
struct Particles {
  Indices<Real> at;

  auto operator()(const auto& field) const { return gather(field.data(), at); }
};

/// Particles that follow each other, as many as there are lanes.
template <class Real>
struct Row {
  size_t first;

  auto operator()(const auto& field) const { return load(field.data() + first); }
  void set(auto& field, const auto& values) const { store(values, field.data() + first); }
};

/// The last particles, fewer than there are lanes; the lanes left over hold zeros, and are not stored.
template <class Real>
struct Tail {
  size_t first, count;

  template <class T>
  auto operator()(const std::vector<T>& field) const {
    T values[lane_count<Real>]{};
    std::copy_n(field.data() + first, count, values);
    return load(values);
  }
  template <class T>
  void set(std::vector<T>& field, const auto& values) const {
    T all[lane_count<Real>];
    store(values, all);
    std::copy_n(all, count, field.data() + first);
  }
};

/// The mask of a comparison that holds in every lane.
struct AllLanes {};

/// The values of `a` in the lanes of the mask, those of `b` in the others.
template <class Value>
Value select(AllLanes, Value a, Value) {
  return a;
}
template <class M, class Value>
Value select(M mask, Value a, Value b) {
  return mask ? a : b;
}

/// Lengths of the lists of particles i; 0 for those that only fill up.
template <class Real>
Indices<Real> lengths_of(const Row<Real>& i, const std::vector<glm::uvec2>& list) {
  const glm::uvec2* own = list.data() + i.first;
  return split(load_as<Indices<Real>>(own), load_as<Indices<Real>>(own + lane_count<Real> / 2)).y;
}
template <class Real>
Indices<Real> lengths_of(const Tail<Real>& i, const std::vector<glm::uvec2>& list) {
  Indices<Real> lengths{};
  for (size_t l = 0; l < i.count; ++l) lengths[l] = list[i.first + l].y;
  return lengths;
}

/// The lane-wise least and largest of two halves, down to two lanes, whose least and largest are left.
template <class Numbers, int... lane>
std::pair<uint32_t, uint32_t> extremes(Numbers least, Numbers largest, std::integer_sequence<int, lane...>) {
  constexpr int half = sizeof...(lane);
  if constexpr (half == 1) {
    return {std::min(least[0], least[1]), std::max(largest[0], largest[1])};
  } else {
    const auto a = __builtin_shufflevector(least, least, lane...),
               b = __builtin_shufflevector(least, least, (half + lane)...),
               c = __builtin_shufflevector(largest, largest, lane...),
               d = __builtin_shufflevector(largest, largest, (half + lane)...);
    return extremes<std::remove_cvref_t<decltype(a)>>(a < b ? a : b, c > d ? c : d,
                                                      std::make_integer_sequence<int, half / 2>());
  }
}

/// What is fetched into a cache while lists are walked over, line by line, with registers as wide as a line:
/// narrower ones compute for about as long as the list takes to come. Here nothing: the processor fetches
/// what is merely read in a row by itself.
struct NoPrefetch {
  uint64_t entries(const auto&, size_t, uint64_t) const { return 0; }
};
/// Entries that come next, into the first level.
struct PrefetchNext {
  static constexpr int locality = 3;
  uint64_t entries(const auto&, size_t, uint64_t) const { return 8 * slice_width; }
};
/// The lists of particles so many further on, where another stage goes next, into the second level.
struct PrefetchFurther {
  static constexpr int locality = 2;
  size_t particles;

  uint64_t entries(const auto& state, size_t i, uint64_t first) const {
    return state.list[std::min<size_t>(i + particles, state.params.n - 1)].x - first;
  }
};

/// Walks over the lists of particles i: calls visit(block, j, there) for their first neighbours j, their
/// second ones and so on. `block` is where the x components of the gradients stand. `there` is a mask:
/// where a list has ended, j is a particle, but none to count.
template <class Real, class Group, class Fetch, class Visit>
[[gnu::always_inline]] inline void walk(const State<Real>& state, const Group& i, Fetch fetch,
                                        const Visit& visit) {
  const Indices<Real> length = lengths_of(i, state.list);
  const auto lengths = __builtin_convertvector(length, Mask<Real>);
  const auto [shortest, longest] =
      extremes(length, length, std::make_integer_sequence<int, lane_count<Real> / 2>());
  const uint64_t first = state.list[i.first].x, ahead = fetch.entries(state, i.first, first);
  const uint32_t* index = state.index.data() + first;
  const Real* gradient = state.gradient.data() + 2 * ahead;
  uint64_t block = 2 * first - first % slice_width;
  uint32_t k = 0;
  for (; k < shortest; ++k, index += slice_width, block += 2 * slice_width) {
    if constexpr (vector_bytes == 64 && !std::is_same_v<Fetch, NoPrefetch>) {
      __builtin_prefetch(index + ahead, 0, Fetch::locality);
      __builtin_prefetch(gradient + block, 0, Fetch::locality);
      __builtin_prefetch(gradient + block + slice_width, 0, Fetch::locality);
    }
    visit(block, Particles<Real>{load_as<Indices<Real>>(index)}, AllLanes{});
  }
  // Where a list has ended, its entries may hold anything.
  for (; k < longest; ++k, index += slice_width, block += 2 * slice_width) {
    const auto any = load_as<Indices<Real>>(index);
    visit(block, Particles<Real>{length > k ? any : static_cast<uint32_t>(i.first) - Indices<Real>{}},
          lengths > static_cast<MaskElement<Real>>(k));
  }
}
template <class Real, class Group, class Visit>
[[gnu::always_inline]] inline void walk(const State<Real>& state, const Group& i, const Visit& visit) {
  walk(state, i, PrefetchNext{}, visit);
}

/// Calls f(i) for the particles of a part, as many at a time as fit into a register.
template <class Real, class F>
void for_each_group(Range part, F&& f) {
  constexpr size_t width = lane_count<Real>;
  size_t first = part.first;
  for (; first + width <= part.last; first += width) f(Row<Real>{first});
  if (first < part.last) f(Tail<Real>{first, part.last - first});
}

/// Calls f for the groups of all particles.
template <class Real, class F>
void for_each_group(const State<Real>& state, F&& f) {
  for_each_part(state, [&](Range part) { for_each_group<Real>(part, f); });
}

/// Calls finish(i, sums) for the particles i of a part, as many at a time as fit into a register, with the
/// sums of what term(i, j, dW) gives for their neighbours j: an array of values, as many as `start` has,
/// which are added before. i(state.q) are the particles' values of q, i.set(state.q, values) changes them.
template <class Real, size_t count, class Term, class Finish, class Fetch = PrefetchNext>
void sum_over_neighbours(const State<Real>& state, Range part, const std::array<Real, count>& start,
                         const Term& term, const Finish& finish, Fetch fetch = {}) {
  const Real* gradient = state.gradient.data();
  for_each_group<Real>(
      part, [&](const auto& i) __attribute__((always_inline)) {
        std::array<Vector<Real>, count> sums;
        for (size_t c = 0; c < count; ++c) sums[c] = broadcast(start[c]);
        walk(state, i, fetch, [&](uint64_t block, const Particles<Real>& j, auto there) {
          const Pair<Vector<Real>> dW{load(gradient + block), load(gradient + block + slice_width)};
          const auto terms = term(i, j, dW);
          for (size_t c = 0; c < count; ++c) sums[c] += select(there, terms[c], Vector<Real>{});
        });
        finish(i, sums);
      });
}

/// Calls finish for all particles.
template <class Real, size_t count, class Term, class Finish, class Fetch = PrefetchNext>
void sum_over_neighbours(const State<Real>& state, const std::array<Real, count>& start, const Term& term,
                         const Finish& finish, Fetch fetch = {}) {
  for_each_part(state, [&](Range part) { sum_over_neighbours(state, part, start, term, finish, fetch); });
}

}  // namespace sluice::cpu::SLUICE_SET
