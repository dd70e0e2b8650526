// IISPH: one step of the projected iteration on q = p/rho^2 [Hunkler 2022, algorithm 6, there written in p]:
//   q := max(q + t (s - Ap)/A_ii, 0)
// The stage `stop_test` chooses t, and whether to start from the last q, from nothing, or to go back to the best q of
// this solve. A particle with A_ii = 0 (nobody in reach) keeps its q.

#include "lib/vectors.glsl"

void run(uint i) {
  vec4 chosen = load(solve, 0);
  float t = chosen.z, start = chosen.w;
  float q_i = q[i], Ap_i = load(Ap, i), A = load(A_ii, i);
  float best = q_best[i];
  precise float moved = q_i + t * (load(s, i) - Ap_i) / A;
  moved = A == 0.0 ? q_i : larger(0.0, moved);
  if (chosen.x == chosen.y) q_best[i] = q_i;
  if (params.solver != solver_jacobi) {
    q_before[i] = q_i;
    Ap_before[i] = Ap_i;
  }
  q[i] = start < 0.0 ? best : start == 0.0 ? 0.0 : moved;
}
