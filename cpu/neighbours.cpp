// The neighbours of every particle, r < 2H, in ascending order: searched once per step, walked by every stage
// after it [Hunkler 2022, algorithm 4]. In three passes: the lengths of all lists; a place for each slice of
// 16 particles, as long as its longest list; and the entries. When the list is too short, list_needed says
// how large it has to be, and all lists are left empty.
//
// Layout: entry k of the particle in lane l of a slice stands at first + 16 k + l; what fills up the shorter
// lists of a slice means nothing.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// Number of neighbours of particle i; list_beyond_bounds, so that no list will do, when there are too many
/// candidates.
template <class Real>
uint32_t count_neighbours(const State<Real>& state, size_t i) {
  const glm::vec<2, Real> x_i = state.x[i];
  uint32_t found = 0, candidates = 0;
  for_each_row(state.C, state.params.columns, cell_of(state.params, x_i), [&](uint32_t first, uint32_t last) {
    candidates += last - first;
    if (candidates > most_rounds) return;
    for (uint32_t j = first; j < last; ++j) {
      const glm::vec<2, Real> x_ij = x_i - state.x[j];
      found += uint32_t{glm::dot(x_ij, x_ij) < state.params.support_squared} & uint32_t{j != i};
    }
  });
  return candidates > most_rounds ? list_beyond_bounds : found;
}

/// Gives each slice its place, and returns how many entries all of them need.
template <class Real>
uint64_t place_slices(State<Real>& state) {
  uint64_t place = 0;
  for (uint32_t first = 0; first < state.params.n; first += slice_width) {
    const uint32_t last = std::min(first + slice_width, state.params.n);
    uint32_t longest = 0;
    for (uint32_t i = first; i < last; ++i) {
      longest = std::max(longest, state.list[i].y);
      state.list[i].x = static_cast<uint32_t>(place) + i - first;
    }
    place += uint64_t{slice_width} * longest;
  }
  return place;
}

template <class Real>
void store_neighbours(State<Real>& state, size_t i) {
  const glm::vec<2, Real> x_i = state.x[i];
  uint64_t entry = state.list[i].x;
  for_each_row(state.C, state.params.columns, cell_of(state.params, x_i), [&](uint32_t first, uint32_t last) {
    for (uint32_t j = first; j < last; ++j) {
      const glm::vec<2, Real> x_ij = x_i - state.x[j];
      if (!(glm::dot(x_ij, x_ij) < state.params.support_squared) || j == i) continue;
      state.index[entry] = j;
      entry += slice_width;
    }
  });
}

}  // namespace

template <class Real>
void neighbours(State<Real>& state) {
  const uint32_t n = state.params.n;
  for_each_index(n, state.threads, [&](size_t i) { state.list[i].y = count_neighbours(state, i); });
  const uint64_t needed = place_slices(state);
  state.list_needed[0] = static_cast<uint32_t>(std::min<uint64_t>(needed, list_beyond_bounds));
  if (needed <= state.sizes.list)
    for_each_index(n, state.threads, [&](size_t i) { store_neighbours(state, i); });
  else
    for_each_index(n, state.threads, [&](size_t i) { state.list[i].y = 0; });
  state.reach = state.any_reach;
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(neighbours)
