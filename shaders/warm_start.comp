// IISPH: the pressure the solve starts from, a share of the last step's [Ihmsen et al. 2014]:
//   p = warm_start p_in,   q = p/rho^2

void run(uint i) {
  float rho_i = load(rho, i);
  precise float pressure = params.warm_start * load(p_in, load(L, i));
  precise float quotient = pressure / (rho_i * rho_i);
  p[i] = pressure;
  q[i] = quotient;
}
