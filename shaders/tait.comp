// WCSPH: pressure from Tait's equation, of the clamped density [Becker & Teschner 2007; WCSPH page]:
//   p = kappa rho0/gamma ((rho/rho0)^gamma - 1),   q = p/rho^2
// Powers are kept as u = (1 + e)^a - 1, with e = rho/rho0 - 1:
//   a -> 2a:      u (2 + u)
//   a -> a/2:     u / (1 + sqrt(1 + u))
//   a, b -> a+b:  u_a + u_b + u_a u_b

/// (1 + e)^gamma - 1 for gamma >= 1, by the binary digits of gamma, from the first one on.
float power_less_one(float e, float gamma) {
  uint whole = uint(gamma);
  precise float power = e;
  for (int digit = findMSB(whole) - 1; digit >= 0; --digit) {
    power *= 2.0 + power;
    if ((whole >> digit & 1u) == 1u) power += e + power * e;
  }
  precise float u = e;
  precise float digits = gamma - float(whole);
  while (digits > 0.0) {
    u /= 1.0 + sqrt(1.0 + u);
    digits *= 2.0;
    if (digits < 1.0) continue;
    power += u + power * u;
    digits -= 1.0;
  }
  return power;
}

void run(uint i) {
  float rho_i = load(rho, i);
  precise float e = (rho_i - params.rho0) / params.rho0;
  precise float pressure = params.tait_factor * power_less_one(e, params.gamma);
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
}
