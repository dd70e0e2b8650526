// The search with wide registers, in one pass: particles of a cell share their candidates, 16 or fewer of
// which are compared at a time, and the lists found are put side by side by shuffles.
//
// Each thread fills its own part of the list from the front. If a part is too short, searching goes on
// without storing, to know what it needs; if the list has that room elsewhere, it is searched again.
#include "cpu/simd/search.hpp"
#include "cpu/simd/transpose.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

template <class Real>
struct Found {
  /// Neighbours of the particles of a slice, lane by lane; after them stand others, never a number of no
  /// particle.
  alignas(64) std::array<Neighbours, slice_width> lanes;
  Cell<Real> cell;  ///< of the last particle searched
  uint32_t reach;   ///< of all cells so far
};

/// Stores the neighbours of particle i from entry `first` on while they are before `end`; returns their
/// number, or list_beyond_bounds, so that no list will do, when there are too many candidates.
template <class Real>
uint32_t search_crowd(State<Real>& state, uint32_t i, uint64_t first, uint64_t end) {
  const uint32_t cell = cell_of(state.params, state.x[i]);
  uint64_t candidates = 0;
  for_each_row(state.C, state.params.columns, cell,
               [&](uint32_t row_first, uint32_t row_last) { candidates += row_last - row_first; });
  if (candidates > most_rounds) return list_beyond_bounds;
  uint32_t count = 0;
  for_each_row(state.C, state.params.columns, cell, [&](uint32_t row_first, uint32_t row_last) {
    for (uint32_t j = row_first; j < row_last; ++j) {
      const glm::vec<2, Real> x_ij = state.x[i] - state.x[j];
      if (!(glm::dot(x_ij, x_ij) < state.params.support_squared) || j == i) continue;
      const uint64_t entry = first + uint64_t{slice_width} * count++;
      if (entry < end) state.index[entry] = j;
    }
  });
  return count;
}

/// Finds the neighbours of particles first to last - 1 and counts them, as long as there is no crowd; returns
/// whether there is none.
template <class Real>
bool find_slice(const State<Real>& state, Found<Real>& found, uint32_t first, uint32_t last,
                uint32_t* counts) {
  std::array<uint32_t, slice_width> places;
  for (uint32_t i = first; i < last; ++i) places[i - first] = cell_of(state.params, state.x[i]);
  bool crowd = false;
  for (uint32_t i = first; i < last; ++i) {
    if (places[i - first] != found.cell.place) {
      enter(state, places[i - first], found.cell);
      found.reach = std::max(found.reach, found.cell.reach);
    }
    crowd |= found.cell.crowded;
    if (crowd) continue;
    counts[i - first] = find(found.cell, i, state.x[i], state.params.support_squared, found.lanes[i - first]);
  }
  return !crowd;
}

/// Writes the first `longest` neighbours found to `index`.
template <class Real>
void store_slice(const Found<Real>& found, uint32_t longest, uint32_t* index) {
  for (uint32_t k = 0; k < longest; k += 4, index += 4 * slice_width) {
    for (uint32_t lane = 0; lane < slice_width; lane += word_count) {
      const auto entries = transposed(&found.lanes[lane], k);
      for (uint32_t e = 0; e < std::min(longest - k, 4u); ++e)
        store(entries[e], index + e * slice_width + lane);
    }
  }
}

/// Makes the lists of the slice of particle `first`, from `cursor` on if there is room for them before `end`;
/// returns the length of the longest.
template <class Real>
uint32_t search_slice(State<Real>& state, Found<Real>& found, uint32_t first, uint64_t cursor, uint64_t end) {
  const uint32_t last = std::min(first + slice_width, state.params.n);
  std::array<uint32_t, slice_width> counts{};
  const bool crowd = !find_slice(state, found, first, last, counts.data());
  for (uint32_t i = first; crowd && i < last; ++i)
    counts[i - first] = search_crowd(state, i, cursor + (i - first), end);
  for (uint32_t i = first; i < last; ++i)
    state.list[i] = {static_cast<uint32_t>(cursor + (i - first)), counts[i - first]};
  const uint32_t longest = *std::max_element(counts.begin(), counts.end());
  if (cursor + uint64_t{slice_width} * longest > end) return longest;
  if (!crowd) {
    store_slice(found, longest, &state.index[cursor]);
    return longest;
  }
  for (uint32_t lane = 0; lane < slice_width; ++lane) {
    for (uint32_t k = counts[lane]; k < longest; ++k)
      state.index[cursor + uint64_t{slice_width} * k + lane] = first;
  }
  return longest;
}

/// Where in the list the part of a thread begins: each has what it needed last time, and its share of the
/// rest.
template <class Real>
uint64_t begin_of_part(const State<Real>& state, uint64_t part) {
  const std::vector<uint64_t>& needs = state.part_needs;
  const auto sum = [&](uint64_t end) {
    return std::accumulate(needs.begin(), needs.begin() + long(end), uint64_t{0});
  };
  const uint64_t all = sum(needs.size()), slots = state.sizes.list / slice_width * slice_width;
  if (all > slots) return slots / slice_width * part / needs.size() * slice_width;
  return sum(part) + (slots - all) / slice_width * part / needs.size() * slice_width;
}

/// Searches all parts side by side, notes what each of them needs, and returns whether all had the room.
template <class Real>
bool search_parts(State<Real>& state) {
  const uint32_t n = state.params.n;
  const uint64_t slices = (n + slice_width - 1) / slice_width, parts = state.part_needs.size();
  std::vector<uint64_t>& needs = state.found_needs;
  uint32_t reach = 0;
  int short_parts = 0;
#pragma omp parallel for num_threads(static_cast <int>(parts)) schedule(static) reduction(max : reach) reduction(+ : short_parts)
  for (uint64_t part = 0; part < parts; ++part) {
    const uint64_t begin = begin_of_part(state, part), end = begin_of_part(state, part + 1);
    uint64_t cursor = begin;
    Found<Real> found{};
    for (uint64_t slice = slices * part / parts; slice < slices * (part + 1) / parts; ++slice) {
      const uint32_t longest =
          search_slice(state, found, static_cast<uint32_t>(slice * slice_width), cursor, end);
      cursor += uint64_t{slice_width} * longest;
    }
    needs[part] = cursor - begin;
    if (cursor > end) ++short_parts;
    reach = std::max(reach, found.reach);
  }
  state.reach = reach;
  state.part_needs.swap(needs);
  return short_parts == 0;
}

}  // namespace

template <class Real>
void neighbours(State<Real>& state) {
  const uint64_t slices = (uint64_t{state.params.n} + slice_width - 1) / slice_width;
  const uint64_t parts = std::min<uint64_t>(static_cast<uint64_t>(state.threads), slices);
  if (state.part_needs.size() != parts) {
    state.part_needs.assign(parts, 0);
    state.found_needs.assign(parts, 0);
  }
  bool fits = search_parts(state);
  const uint64_t needed = std::accumulate(state.part_needs.begin(), state.part_needs.end(), uint64_t{0});
  // There is room, and now it is known where it is needed.
  if (!fits && needed <= state.sizes.list) fits = search_parts(state);
  state.list_needed[0] = static_cast<uint32_t>(std::min<uint64_t>(needed, list_beyond_bounds));
  if (!fits) for_each_index(state.params.n, state.threads, [&](size_t i) { state.list[i].y = 0; });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(neighbours)
