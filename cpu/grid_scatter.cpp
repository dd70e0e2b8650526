// Puts every particle into its cell in L, moving C from the cells' ends to their beginnings
// [Hunkler 2022, algorithm 3]. One thread does it, as in grid_count. From the last particle to the first, so
// that those of a cell keep their order, which leaves little for grid_order to do.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void grid_scatter(State<Real>& state) {
  for (uint32_t i = state.params.n; i-- > 0;) state.L[--state.C[state.cell[i]]] = i;
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(grid_scatter)
