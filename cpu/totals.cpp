// The entries of diagnostics over all chunks: sums, and the largest of the largest.
#include "cpu/fold.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void totals(State<Real>& state) {
  const uint64_t chunks = state.sizes.chunks();
  for (uint32_t total = 0; total < total_count; ++total) {
    const Real* values = state.diagnostic_sums.data() + total * chunks;
    state.totals[total] = total < first_max_total ? fold(values, chunks, [](Real a, Real b) { return a + b; })
                                                  : fold(values, chunks, larger<Real>);
  }
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(totals)
