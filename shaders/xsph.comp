// XSPH: velocities smoothed over the neighbours, as an acceleration [WCSPH page]:
//   a_n -= (alpha m/dt) sum_j (1/rho_j) (v_i - v_j) W_ij

#include "lib/kernel.glsl"
#include "lib/neighbours.glsl"

void run(uint i) {
  vec2 x_i = load(x, i), v_i = load(v, i);
  precise vec2 sum = vec2(0.0);
  for_each_neighbour(i, entry) {
    uint j = load(index, entry);
    precise vec2 x_ij = x_i - load(x, j);
    precise vec2 v_ij = v_i - load(v, j);
    precise float weight = kernel(length_of(x_ij)) / load(rho, j);
    sum += weight * v_ij;
  }
  precise vec2 a = a_n[i] - params.xsph * sum;
  a_n[i] = a;
}
