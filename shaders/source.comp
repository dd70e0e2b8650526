// IISPH: source of the pressure system [Hunkler 2022, eq. 5.17; Ihmsen et al. 2014]:
//   s_i = w (rho0 - rho_i) - dt ( m sum_j (v*_i - v*_j).dW_ij + v*_i.B_i )

#include "lib/neighbours.glsl"
#include "lib/vectors.glsl"

void run(uint i) {
  vec2 v_i = load(v_star, i);
  precise float sum = 0.0;
  for_each_neighbour(i, entry) {
    precise vec2 v_ij = v_i - load(v_star, load(index, entry));
    sum += dot_of(v_ij, gradient_of(entry));
  }
  sum = params.m * sum;
  if (needs_boundary) sum += dot_of(v_i, load(wall_gradient, i));
  precise float right_hand_side = params.source_weight * (params.rho0 - load(rho, i)) - params.dt * sum;
  s[i] = right_hand_side;
}
