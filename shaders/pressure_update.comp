// IISPH: one relaxed Jacobi step, p := max(p + omega (s - Ap)/A_ii, 0), and q = p/rho^2; per chunk of 64 particles the
// residual |Ap - s|/rho0, summed in their order over those whose updated pressure did not fall below zero, and how
// many these are [Hunkler 2022, algorithm 6]. A particle with A_ii = 0 keeps its pressure and is not counted.

shared float errors[group_size];
shared float counted[group_size];

void run_group(uint group) {
  uint lane = gl_LocalInvocationIndex;
  uint i = group * group_size + lane;
  errors[lane] = 0.0;
  counted[lane] = 0.0;
  if (i < count && A_ii[i] != 0.0) {
    precise float difference = s[i] - Ap[i];
    precise float pressure = p[i] + params.omega * difference / A_ii[i];
    precise float error = abs(difference) / params.rho0;
    bool below = pressure < 0.0;
    float rho_i = rho[i];
    pressure = below ? 0.0 : pressure;  // not max(), which may hide NaN
    precise float quotient = pressure / (rho_i * rho_i);
    p[i] = pressure;
    q[i] = quotient;
    errors[lane] = below ? 0.0 : error;
    counted[lane] = below ? 0.0 : 1.0;
  }
  barrier();
  if (lane % chunk_width != 0u || i >= count) return;
  precise float error_sum = 0.0, count_sum = 0.0;
  for (uint k = lane; k < lane + chunk_width; ++k) {
    error_sum += errors[k];
    count_sum += counted[k];
  }
  uint chunks = (count + chunk_width - 1u) / chunk_width;
  residual_sums[i / chunk_width] = error_sum;
  residual_sums[chunks + i / chunk_width] = count_sum;
}
