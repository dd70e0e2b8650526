// SSPH: pressure from a state equation, p = max(k (rho/rho0 - 1), 0) [Hunkler 2022, eq. 5.5], and q = p/rho^2.

#include "lib/vectors.glsl"

void run(uint i) {
  float rho_i = load(rho, i);
  precise float pressure = params.k * (rho_i / params.rho0 - 1.0);
  pressure = larger(0.0, pressure);
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
}
