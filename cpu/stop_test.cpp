// IISPH: the sums of the stage `residual` over all chunks; from them the error e, whether the solve is over,
// and the step t of the update that follows.
//
// With stop = "density", 0 if nobody counts [Hunkler 2022, algorithm 6]:
//
//   e = error / (rho0 counted)
//
// With stop = "residual", 0 if nothing is left to solve:
//
//   e = sqrt(squares) / sqrt(source_squares)
//
// The solve is over when e < tolerance and enough sweeps are done, at the last sweep allowed, and when e is
// not a number. If it did not converge and has left the q with the smallest e behind, the update goes back to
// that. A first guess that is ten times worse than none is dropped. These tests compare products, so that no
// division decides when a solve ends.
//
// Of the Jacobi iteration, and of any in its first sweep and when it is over:
//
//   t = omega
//
// Else in turns [Barzilai & Borwein 1988; Dai & Fletcher 2005], if SY > 0:
//
//   t = SS/SY,   t = SY/YY
//
// Such a step may be long and for once lead away; nobody would look at e after the last one.
#include "cpu/fold.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// Bounds of a Barzilai-Borwein step.
constexpr double shortest_step = 0.2, longest_step = 1000;
/// `squares` of a first guess that is dropped, in those of none at all.
constexpr double far_worse = 100;

template <class Real>
Real total(const State<Real>& state, ResidualSum which) {
  const uint64_t chunks = state.sizes.chunks();
  const Real* sums = state.residual_sums.data() + static_cast<uint32_t>(which) * chunks;
  return fold(sums, chunks, [](Real a, Real b) { return a + b; });
}

template <class Real>
Real step_length(const State<Real>& state, uint32_t sweeps_before) {
  const Real omega = state.params.omega;
  if (state.params.solver == static_cast<uint32_t>(Solver::jacobi) || sweeps_before == 0) return omega;
  const Real SY = total(state, ResidualSum::SY);
  if (!(SY > Real(0))) return omega;
  const Real t =
      sweeps_before % 2 == 1 ? total(state, ResidualSum::SS) / SY : SY / total(state, ResidualSum::YY);
  const Real shortest = static_cast<Real>(shortest_step), longest = static_cast<Real>(longest_step);
  return !(t > shortest) ? shortest : t > longest ? longest : t;  // the shortest if t is not a number
}

}  // namespace

template <class Real>
void stop_test(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const Real squares = total(state, ResidualSum::squares);
  const Real source_squares = total(state, ResidualSum::source_squares);
  const bool by_residual = params.stop == static_cast<uint32_t>(Stop::residual);
  const Real error = by_residual ? squares : total(state, ResidualSum::error);
  const Real base = by_residual ? source_squares : params.rho0 * total(state, ResidualSum::counted);
  const Real bound = (by_residual ? params.tolerance * params.tolerance : params.tolerance) * base;
  const Real quotient = error == Real(0) ? Real(0) : error / base;
  const Real e = by_residual ? std::sqrt(quotient) : quotient;

  const uint32_t before = state.sweeps[0].x, done = before + 1;
  const bool far_off = before == 0 && squares > Real(far_worse) * source_squares;
  const bool solved = !far_off && (error < bound || error == Real(0));
  const bool goes_on =
      done < params.max_iterations && (done < params.min_iterations || (!solved && error >= Real(0)));
  const Solve solve = goes_on ? Solve::unfinished : solved ? Solve::converged : Solve::capped;
  state.sweeps[0] = {done, static_cast<uint32_t>(solve)};

  const Real none_yet = std::numeric_limits<Real>::infinity();
  const Real smallest_before = before == 0 ? none_yet : state.solve[0].y;
  const Real smallest = !far_off && e < smallest_before ? e : smallest_before;
  const bool goes_back = solve == Solve::capped && smallest < none_yet && e != smallest;
  const Real t = goes_on ? step_length(state, before) : params.omega;
  state.solve[0] = {e, smallest, t, Real(far_off ? 0 : goes_back ? -1 : 1)};
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(stop_test)
