// IISPH: how far the pressure system is from being solved, as sums per chunk of particles [Hunkler 2022, algorithm 6;
// Barzilai & Borwein 1988]; one invocation per chunk. With r = s - Ap, and with S and Y the last changes of q and of
// -r/A_ii, in the inner product weighted by -A_ii:
//   error           |r| of those whose q a step with t = omega does not take below zero
//   counted         how many these are
//   squares         r^2, but where q = 0 only of r < 0
//   source_squares  s^2 where s < 0
//   SS = S'S    SY = S'Y    YY = Y'Y
// A particle with A_ii = 0 has no part in any.

void run(uint chunk) {
  precise float error = 0.0, counted = 0.0, squares = 0.0, source_squares = 0.0, SS = 0.0, SY = 0.0, YY = 0.0;
  for (uint i = chunk * chunk_width; i < min((chunk + 1u) * chunk_width, params.n); ++i) {
    float A = load(A_ii, i), q_i = load(q, i), s_i = load(s, i), Ap_i = load(Ap, i);
    bool counts = A != 0.0;
    precise float r = s_i - Ap_i;
    precise float moved = q_i + params.omega * r / A;
    precise float r_squared = r * r, s_squared = s_i * s_i;
    bool stays = counts && !(moved < 0.0);
    error += stays ? abs(r) : 0.0;
    counted += stays ? 1.0 : 0.0;
    squares += counts && (q_i > 0.0 || !(r > 0.0)) ? r_squared : 0.0;
    source_squares += counts && s_i < 0.0 ? s_squared : 0.0;
    if (params.solver == solver_jacobi) continue;
    precise float S = q_i - load(q_before, i), change = load(Ap_before, i) - Ap_i;  // -A_ii Y
    precise float SS_i = S * S * A, SY_i = S * change, YY_i = change * change / A;
    SS -= counts ? SS_i : 0.0;
    SY += counts ? SY_i : 0.0;
    YY -= counts ? YY_i : 0.0;
  }
  residual_sums[residual_error * count + chunk] = error;
  residual_sums[residual_counted * count + chunk] = counted;
  residual_sums[residual_squares * count + chunk] = squares;
  residual_sums[residual_source_squares * count + chunk] = source_squares;
  residual_sums[residual_SS * count + chunk] = SS;
  residual_sums[residual_SY * count + chunk] = SY;
  residual_sums[residual_YY * count + chunk] = YY;
}
