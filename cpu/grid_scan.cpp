// Inclusive prefix sum of C: afterwards C[c] is the end of cell c in L [Hunkler 2022, algorithm 3].
#include <numeric>

#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void grid_scan(State<Real>& state) {
  std::partial_sum(state.C.begin(), state.C.end(), state.C.begin());
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(grid_scan)
