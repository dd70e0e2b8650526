// IISPH: the two sums of pressure_update over all chunks, and whether the solve is over [Hunkler 2022, algorithm 6].
// Sweeps that were asked for beyond the last one get no groups to run, so they change nothing.

#include "lib/vectors.glsl"

#define VALUES residual_sums
#include "lib/fold.glsl"

void run(uint i) {
#if PASS == 0
  fold_into_scratch(i, false);
#else
  if (sweeps[0].y != solve_unfinished) return;
  precise float error = fold_group(0u, 0u, false);
  precise float counted = fold_group(1u, 0u, false);
  residual[0] = vec2(error, counted);

  uint done = sweeps[0].x + 1u;
  precise float bound = params.tolerance * counted;
  bool above = counted > 0.0 && error >= bound;  // false for NaN: it ends the solve
  bool goes_on = done < params.max_iterations && (done < params.min_iterations || above);
  bool converged = counted == 0.0 || error < bound;
  uint solve = goes_on ? solve_unfinished : converged ? solve_converged : solve_capped;
  sweeps[0] = uvec2(done, solve);
  if (solve != solve_unfinished) {
    sweep_groups[0] = 0u;  // of passes over particles
    sweep_groups[3] = 0u;  // of passes over chunks
  }
#endif
}
