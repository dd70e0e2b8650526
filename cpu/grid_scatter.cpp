// Puts every particle into its cell in L, moving C from the cells' ends to their beginnings
// [Hunkler 2022, algorithm 3]. The order within a cell is left to chance; grid_order settles it.
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void grid_scatter(State<Real>& state) {
  for_each_index(state.params.n, state.threads, [&](uint32_t i) {
    uint32_t& end = state.C[state.cell[i]];
    uint32_t place;
#pragma omp atomic capture
    place = --end;
    state.L[place] = i;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(grid_scatter)
