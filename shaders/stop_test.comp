// IISPH: the sums of the stage `residual` over all chunks; from them the error e, whether the solve is over, and the step
// t of the update that follows [Hunkler 2022, algorithm 6; Barzilai & Borwein 1988]; cpu/stop_test.cpp says how. Sweeps
// that were asked for beyond the last one get no groups to run, so they change nothing.

#include "lib/vectors.glsl"

#define VALUES residual_sums
#include "lib/fold.glsl"

// Bounds of a Barzilai-Borwein step; `squares` of a first guess that is dropped, in those of none at all.
const float shortest_step = 0.2, longest_step = 1000.0, far_worse = 100.0;
const uint infinity_bits = 0x7f800000u;

float step_length(uint sweeps_before) {
  if (params.solver == solver_jacobi || sweeps_before == 0u) return params.omega;
  precise float SY = fold_group(residual_SY, 0u, false);
  if (!(SY > 0.0)) return params.omega;
  precise float t = sweeps_before % 2u == 1u ? fold_group(residual_SS, 0u, false) / SY
                                             : SY / fold_group(residual_YY, 0u, false);
  return !(t > shortest_step) ? shortest_step : t > longest_step ? longest_step : t;
}

void run(uint i) {
#if PASS == 0
  fold_into_scratch(i, false);
#else
  if (sweeps[0].y != solve_unfinished) {
    sweep_groups[groups_of_particles] = 0u;
    sweep_groups[groups_of_chunks] = 0u;
    sweep_groups[groups_of_update] = 0u;  // the last one has run
    sweep_groups[groups_of_test] = 0u;
    return;
  }
  precise float squares = fold_group(residual_squares, 0u, false),
                source_squares = fold_group(residual_source_squares, 0u, false);
  bool by_residual = params.stop == stop_residual;
  precise float error = by_residual ? squares : fold_group(residual_error, 0u, false);
  precise float base = params.rho0 * fold_group(residual_counted, 0u, false);
  precise float bound = params.tolerance * base;
  if (by_residual) {
    base = source_squares;
    bound = params.tolerance * params.tolerance * base;
  }
  precise float e = error == 0.0 ? 0.0 : error / base;
  if (by_residual) e = sqrt(e);

  uint before = sweeps[0].x, done = before + 1u;
  precise float limit = far_worse * source_squares;
  bool far_off = before == 0u && squares > limit;
  bool solved = !far_off && (error < bound || error == 0.0);
  bool goes_on =
      done < params.max_iterations && (done < params.min_iterations || (!solved && error >= 0.0));  // not if NaN
  uint state = goes_on ? solve_unfinished : solved ? solve_converged : solve_capped;
  sweeps[0] = uvec2(done, state);

  float none_yet = uintBitsToFloat(infinity_bits);
  float smallest_before = before == 0u ? none_yet : solve[0].y;
  float smallest = !far_off && e < smallest_before ? e : smallest_before;
  bool goes_back = state == solve_capped && smallest < none_yet && e != smallest;
  float t = goes_on ? step_length(before) : params.omega;
  solve[0] = vec4(e, smallest, t, far_off ? 0.0 : goes_back ? -1.0 : 1.0);
  if (state != solve_unfinished) {
    sweep_groups[groups_of_particles] = 0u;  // but the update goes on
    sweep_groups[groups_of_chunks] = 0u;
  }
#endif
}
