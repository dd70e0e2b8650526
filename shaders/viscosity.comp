// Laplacian viscosity [Hunkler 2022, algorithm 8]:
//   a_n += 2 nu ( m sum_j (1/rho_j) (v_ij.x_ij)/(x_ij.x_ij + 0.01 H^2) dW_ij
//               + (1/rho_i) sum_b m_b (v_i.x_ib)/(x_ib.x_ib + 0.01 H^2) dW_ib )
// The sum over b stands in wall_viscosity.

#include "lib/neighbours.glsl"
#include "lib/vectors.glsl"

void run(uint i) {
  vec2 x_i = load(x, i), v_i = load(v, i);
  precise vec2 sum = vec2(0.0);
  for_each_neighbour(i, entry) {
    uint j = load(index, entry);
    precise vec2 x_ij = x_i - load(x, j);
    precise vec2 v_ij = v_i - load(v, j);
    precise float approach = dot_of(v_ij, x_ij);
    precise float weight = approach / ((dot_of(x_ij, x_ij) + params.viscosity_floor) * load(rho, j));
    sum += weight * gradient_of(entry);
  }
  sum = params.m * sum;
  if (needs_boundary) {
    vec4 t = load(wall_viscosity, i);
    sum += vec2(t.x * v_i.x + t.y * v_i.y, t.z * v_i.x + t.w * v_i.y) / load(rho, i);
  }
  precise vec2 a = a_n[i] + (2.0 * params.nu) * sum;
  a_n[i] = a;
}
