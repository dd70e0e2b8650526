// The neighbours of every particle, r < 2H, in ascending order: searched once per step, walked by every stage
// after it [Hunkler 2022, algorithm 4].
//
// Layout: slices of 16 particles; entry k of the particle in lane l of a slice stands at first + 16 k + l, so
// that a slice is as long as the longest of its lists; what fills up the shorter ones means nothing. Each
// thread fills its own part of the list from the front. If a part is too short, searching goes on without
// storing, list_needed says how large the list has to be, and all lists are left empty.
#include <algorithm>
#include <array>

#include "cpu/search.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// Candidates per particle up to which those of a slice are put aside in one go; where more of them crowd,
/// they are searched one by one.
constexpr uint32_t most_candidates = 480;

struct Found {
  /// Neighbours of the particles of a slice, lane by lane; after them stand others, never a number of no
  /// particle.
  std::array<std::array<uint32_t, most_candidates + block_width>, slice_width> lanes;
  uint32_t reach;  ///< of all slices so far: numbers of neighbours differ by no more
};

template <class Real>
Candidates candidates_of(const State<Real>& state, uint32_t i) {
  Candidates candidates{i, {}};
  size_t row = 0;
  for_each_row(state.C, state.params.columns, cell_of(state.params, state.x[i]),
               [&](uint32_t first, uint32_t last) {
                 candidates.rows[row++] = {first, last};
               });
  return candidates;
}

/// Stores the neighbours of particle i from entry `first` on while they are before `end`; returns their
/// number.
template <class Real>
uint32_t search_crowd(State<Real>& state, const Candidates& candidates, uint64_t first, uint64_t end) {
  const uint32_t i = candidates.i;
  uint32_t count = 0;
  for (const glm::uvec2 row : candidates.rows) {
    for (uint32_t j = row.x; j < row.y; ++j) {
      const glm::vec<2, Real> x_ij = state.x[i] - state.x[j];
      if (!(glm::dot(x_ij, x_ij) < state.params.support_squared) || j == i) continue;
      const uint64_t entry = first + uint64_t{slice_width} * count++;
      if (entry < end) state.index[entry] = j;
    }
  }
  return count;
}

/// Makes the lists of the slice of particle `first`, from `cursor` on if there is room for them before `end`;
/// returns the length of the longest.
template <class Real>
uint32_t search_slice(State<Real>& state, Found& found, uint32_t first, uint64_t cursor, uint64_t end) {
  const uint32_t n = state.params.n, lanes = std::min(slice_width, n - first);
  std::array<Candidates, slice_width> candidates;
  bool crowd = n < block_width;
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    const auto& [i, rows] = candidates[lane] = candidates_of(state, first + lane);
    found.reach = std::max({found.reach, i - rows.front().x, rows.back().y - i});
    crowd |= candidates[lane].count() > most_candidates;
  }
  std::array<uint32_t, slice_width> counts{};
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    counts[lane] = crowd ? search_crowd(state, candidates[lane], cursor + lane, end)
                         : find(state.x.data(), n, state.params.support_squared, candidates[lane],
                                found.lanes[lane].data());
    state.list[first + lane] = {static_cast<uint32_t>(cursor + lane), counts[lane]};
  }
  const uint32_t longest = *std::max_element(counts.begin(), counts.end());
  if (cursor + uint64_t{slice_width} * longest > end) return longest;
  for (uint32_t k = 0; k < longest; ++k) {
    uint32_t* index = &state.index[cursor + uint64_t{slice_width} * k];
    for (uint32_t lane = 0; lane < slice_width; ++lane) {
      if (!crowd)
        index[lane] = found.lanes[lane][k];
      else if (k >= counts[lane])
        index[lane] = first;
    }
  }
  return longest;
}

}  // namespace

template <class Real>
void neighbours(State<Real>& state) {
  const uint32_t n = state.params.n;
  const uint64_t slices = (n + slice_width - 1) / slice_width;
  const uint64_t parts = std::min<uint64_t>(static_cast<uint64_t>(state.threads), slices);
  uint64_t longest_part = 0;
  uint32_t reach = 0;
#pragma omp parallel for num_threads(static_cast <int>(parts)) schedule(static) \
    reduction(max                                                               \
              : longest_part, reach)
  for (uint64_t part = 0; part < parts; ++part) {
    const auto share = [&](uint64_t of, uint64_t p) { return of * p / parts; };
    const uint64_t begin = share(state.sizes.list / slice_width, part) * slice_width;
    const uint64_t end = share(state.sizes.list / slice_width, part + 1) * slice_width;
    uint64_t cursor = begin;
    Found found{};
    for (uint64_t slice = share(slices, part); slice < share(slices, part + 1); ++slice) {
      const uint32_t longest =
          search_slice(state, found, static_cast<uint32_t>(slice * slice_width), cursor, end);
      cursor += uint64_t{slice_width} * longest;
    }
    longest_part = std::max(longest_part, cursor - begin);
    reach = std::max(reach, found.reach);
  }
  state.reach = reach;
  const uint64_t needed = longest_part * parts;
  state.list_needed[0] = static_cast<uint32_t>(std::min<uint64_t>(needed, list_beyond_bounds));
  if (needed > state.sizes.list) for_each_index(n, state.threads, [&](size_t i) { state.list[i].y = 0; });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(neighbours)
