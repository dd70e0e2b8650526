// IISPH: the two sums of pressure_update over all chunks, and whether the solve is over. Their quotient is
// the error e of the stop test, which is met when e < tolerance and enough sweeps are done [Hunkler 2022,
// algorithm 6]; nobody counted means e = 0. The test compares error with tolerance times count, so that no
// division decides when a solve ends.
#include "cpu/fold.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void residual(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const uint64_t chunks = state.sizes.chunks();
  const auto sum = [](Real a, Real b) { return a + b; };
  const Real* sums = state.residual_sums.data();
  const Real error = fold(sums, chunks, sum), counted = fold(sums + chunks, chunks, sum);
  state.residual[0] = {error, counted};

  const uint32_t done = state.sweeps[0].x + 1;
  const Real bound = params.tolerance * counted;
  const bool above = counted > Real(0) && error >= bound;  // false for NaN: it ends the solve
  const bool goes_on = done < params.max_iterations && (done < params.min_iterations || above);
  const bool converged = counted == Real(0) || error < bound;
  const Solve solve = goes_on ? Solve::unfinished : converged ? Solve::converged : Solve::capped;
  state.sweeps[0] = {done, static_cast<uint32_t>(solve)};
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(residual)
