// SSPH: pressure from a state equation [Hunkler 2022, eq. 5.5]:
//   p = max(k (rho - rho0)/rho0, 0),   q = p/rho^2

#include "lib/vectors.glsl"

void run(uint i) {
  float rho_i = load(rho, i);
  precise float pressure = params.k * ((rho_i - params.rho0) / params.rho0);
  pressure = larger(0.0, pressure);
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
}
