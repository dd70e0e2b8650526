// IISPH: the two sums of pressure_update over all chunks; their quotient is the error e of the stop test
// [Hunkler 2022, algorithm 6].
#include "cpu/fold.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void residual(State<Real>& state) {
  const uint64_t chunks = state.sizes.chunks();
  const auto sum = [](Real a, Real b) { return a + b; };
  const Real* sums = state.residual_sums.data();
  state.residual[0] = {fold(sums, chunks, sum), fold(sums + chunks, chunks, sum)};
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(residual)
