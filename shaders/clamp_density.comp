// WCSPH: rho := max(rho, rho0) [WCSPH page].

#include "lib/vectors.glsl"

void run(uint i) { rho[i] = larger(params.rho0, rho[i]); }
