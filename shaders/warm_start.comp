// IISPH: the pressure the solve starts from, a share of the last step's [Ihmsen et al. 2014]:
//   q = warm_start p_in/rho^2

void run(uint i) {
  float rho_i = load(rho, i);
  precise float quotient = params.warm_start * load(p_in, load(L, i)) / (rho_i * rho_i);
  q[i] = quotient;
}
