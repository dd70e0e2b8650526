// SSPH: pressure from a state equation, p = max(k (rho/rho0 - 1), 0) [Hunkler 2022, eq. 5.5], and q = p/rho^2.

void run(uint i) {
  float rho_i = load(rho, i);
  precise float pressure = params.k * (rho_i / params.rho0 - 1.0);
  pressure = pressure < 0.0 ? 0.0 : pressure;  // not max(), which may hide NaN
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
}
