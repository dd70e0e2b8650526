// IISPH: one relaxed Jacobi step, p := max(p + omega (s - Ap)/A_ii, 0), and q = p/rho^2; per chunk of 64 particles the
// residual |Ap - s|/rho0, summed in their order over those whose updated pressure did not fall below zero, and how
// many these are [Hunkler 2022, algorithm 6]. A particle with A_ii = 0 keeps its pressure and is not counted. In two
// passes, particles and chunks.

#include "lib/vectors.glsl"

const float not_counted = -1.0;

void run(uint i) {
#if PASS == 0
  float A = load(A_ii, i), old = p[i], rho_i = load(rho, i);
  precise float difference = load(s, i) - load(Ap, i);
  precise float pressure = old + params.omega * difference / A;
  precise float error = abs(difference) / params.rho0;
  bool below = pressure < 0.0;
  pressure = A == 0.0 ? old : larger(0.0, pressure);
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
  scratch[i] = floatBitsToUint(below || A == 0.0 ? not_counted : error);
#else
  precise float error_sum = 0.0, counted = 0.0;
  for (uint k = i * chunk_width; k < min((i + 1u) * chunk_width, params.n); ++k) {
    float error = uintBitsToFloat(scratch[k]);
    bool counts = error != not_counted;  // true for NaN
    error_sum += counts ? error : 0.0;
    counted += counts ? 1.0 : 0.0;
  }
  residual_sums[i] = error_sum;
  residual_sums[count + i] = counted;
#endif
}
