// IISPH: the pressure that the solve of the system in q = p/rho^2 has found:
//   p = q rho^2

void run(uint i) {
  float rho_i = load(rho, i);
  precise float pressure = load(q, i) * (rho_i * rho_i);
  p[i] = pressure;
}
