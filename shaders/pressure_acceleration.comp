// Pressure acceleration; a boundary sample mirrors the pressure of the particle that looks at it, with rho0
// [Hunkler 2022, algorithm 7]. With q = p/rho^2 and B_i = m sum_b dW_ib:
//   a_p = -m sum_j (q_i + q_j) dW_ij - (q_i + p_i/rho0^2) B_i

#include "lib/neighbours.glsl"

void run(uint i) {
  float q_i = load(q, i);
  precise vec2 sum = vec2(0.0);
  for_each_neighbour(i, entry) {
    sum += (q_i + load(q, load(index, entry))) * gradient_of(entry);
  }
  sum = -(params.m * sum);
  if (walls) sum -= (q_i + load(p, i) * params.wall_pressure) * load(wall_gradient, i);
  a_p[i] = sum;
}
