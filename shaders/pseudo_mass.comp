// Pseudo-mass of every boundary sample [Akinci et al. 2012; WCSPH page]:
//   Psi_b = rho0 / sum_l W_bl, over all boundary samples l, itself included

#include "lib/grid.glsl"
#include "lib/kernel.glsl"

void run(uint b) {
  vec2 x_b = load(x_boundary, b);
  uint middle = cell_of(x_b);
  precise float sum = 0.0;
  for (uint row = 0u; row < 3u; ++row) {
    uint first = load(C_boundary, middle + row * params.columns - params.columns - 1u);
    uint last = load(C_boundary, middle + row * params.columns - params.columns + 2u);
    for (uint l = first; l < last; ++l) {
      precise vec2 x_bl = x_b - load(x_boundary, l);
      precise float r_squared = dot_of(x_bl, x_bl);
      precise float r = sqrt(r_squared);
      if (r_squared < params.support_squared) sum += kernel(r);
    }
  }
  precise float mass = params.rho0 / sum;
  Psi[b] = mass;
}
