// Cell of every particle, and how many there are in each: the first pass over the thesis's array C
// [Hunkler 2022, algorithm 3; Lagae and Dutre 2008]. One thread counts, without atomic operations: for
// two threads that was measured to be faster than counters they share; many threads may find otherwise.
#include <algorithm>

#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void grid_count(State<Real>& state) {
  for_each_index(state.params.n, state.threads,
                 [&](size_t i) { state.cell[i] = cell_of(state.params, state.x_in[i]); });
  std::fill(state.C.begin(), state.C.end(), 0u);
  for (uint32_t i = 0; i < state.params.n; ++i) ++state.C[state.cell[i]];
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(grid_count)
