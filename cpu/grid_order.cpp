// Sorts L within each cell by id, so that the order of all later sums depends on the state alone and not on
// who came first to a counter. Differs from [Hunkler 2022, algorithm 3]: there the order within a cell is
// that of insertion.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void grid_order(State<Real>& state) {
  for_each_index(state.sizes.cells, state.threads, [&](size_t cell) {
    const uint32_t first = state.C[cell], last = state.C[cell + 1];
    for (uint32_t place = first + 1; place < last; ++place) {
      const uint32_t particle = state.L[place];
      uint32_t hole = place;
      while (hole > first && state.id_in[state.L[hole - 1]] > state.id_in[particle]) {
        state.L[hole] = state.L[hole - 1];
        --hole;
      }
      state.L[hole] = particle;
    }
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(grid_order)
