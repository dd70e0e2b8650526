// Cell of every particle, and how many there are in each: the first pass over the thesis's array C
// [Hunkler 2022, algorithm 3; Lagae and Dutre 2008].
#include <algorithm>

#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void grid_count(State<Real>& state) {
  std::fill(state.C.begin(), state.C.end(), 0u);
  for_each_index(state.params.n, state.threads, [&](uint32_t i) {
    const uint32_t cell = cell_of(state.params, state.x_in[i]);
    state.cell[i] = cell;
    uint32_t& count = state.C[cell];
#pragma omp atomic
    ++count;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(grid_count)
