// The neighbours of every particle, r < 2H, in ascending order, with their kernel gradients: searched once
// per step, walked by every stage after it [Hunkler 2022, algorithm 4].
//
// Layout: slices of 16 particles; entry k of the particle in lane l of a slice stands at first + 16 k + l, so
// that a slice is as long as the longest of its lists. Each thread fills its own part of the list from the
// front. If a part is too short, searching goes on without storing, list_needed says how large the list has
// to be, and all lists are left empty.
#include <algorithm>
#include <array>

#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {
namespace {

/// Candidates looked at together: their distances are compared without branches, which a processor could not
/// foresee.
constexpr uint32_t block_size = 32;

/// Stores the neighbours of particle i from entry `first` on while they are before `end`; returns their
/// number.
template <class Real>
uint32_t search(State<Real>& state, uint32_t i, uint64_t first, uint64_t end) {
  const ParamsOf<Real>& params = state.params;
  const glm::vec<2, Real> x_i = state.x[i];
  const uint64_t lane = first % slice_width;
  uint32_t count = 0;
  const auto store = [&](uint32_t j) {
    const uint64_t entry = first + uint64_t{slice_width} * count++;
    if (entry >= end) return;
    const glm::vec<2, Real> x_ij = x_i - state.x[j];
    const glm::vec<2, Real> dW = kernel_gradient(params, x_ij, glm::length(x_ij));
    const uint64_t block = 2 * entry - lane;
    state.index[entry] = j;
    state.gradient[block] = dW.x;
    state.gradient[block + slice_width] = dW.y;
  };
  for_each_row(state.C, params.columns, cell_of(params, x_i), [&](uint32_t row_first, uint32_t row_last) {
    for (uint32_t block = row_first; block < row_last; block += block_size) {
      std::array<uint32_t, block_size> found;
      uint32_t found_count = 0;
      for (uint32_t j = block; j < std::min(block + block_size, row_last); ++j) {
        const glm::vec<2, Real> x_ij = x_i - state.x[j];
        found[found_count] = j;
        found_count += static_cast<uint32_t>(glm::dot(x_ij, x_ij) < params.support_squared) &
                       static_cast<uint32_t>(j != i);
      }
      for (uint32_t k = 0; k < found_count; ++k) store(found[k]);
    }
  });
  return count;
}

}  // namespace

template <class Real>
void neighbours(State<Real>& state) {
  const uint32_t n = state.params.n;
  const uint64_t slices = (n + slice_width - 1) / slice_width;
  const uint64_t parts = std::min<uint64_t>(static_cast<uint64_t>(state.threads), slices);
  uint64_t longest_part = 0;
#pragma omp parallel for num_threads(static_cast <int>(parts)) schedule(static) reduction(max : longest_part)
  for (uint64_t part = 0; part < parts; ++part) {
    const auto share = [&](uint64_t of, uint64_t p) { return of * p / parts; };
    const uint64_t begin = share(state.sizes.list / slice_width, part) * slice_width;
    const uint64_t end = share(state.sizes.list / slice_width, part + 1) * slice_width;
    uint64_t cursor = begin;
    for (uint64_t slice = share(slices, part); slice < share(slices, part + 1); ++slice) {
      uint32_t longest = 0;
      for (uint32_t lane = 0; lane < slice_width; ++lane) {
        const uint32_t i = static_cast<uint32_t>(slice * slice_width) + lane;
        if (i >= n) break;
        const uint32_t count = search(state, i, cursor + lane, end);
        state.list[i] = {static_cast<uint32_t>(cursor + lane), count};
        longest = std::max(longest, count);
      }
      cursor += uint64_t{slice_width} * longest;
    }
    longest_part = std::max(longest_part, cursor - begin);
  }
  const uint64_t needed = longest_part * parts;
  state.list_needed[0] = static_cast<uint32_t>(std::min<uint64_t>(needed, list_beyond_bounds));
  if (needed > state.sizes.list) for_each_index(n, state.threads, [&](uint32_t i) { state.list[i].y = 0; });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(neighbours)
