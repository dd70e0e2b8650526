// Pressure acceleration, symmetric in i and j [Hunkler 2022, algorithm 7; WCSPH page]. With q = p/rho^2 and B_i the
// sum over the boundary (stage `boundary`):
//   a_p = -m sum_j (q_i + q_j) dW_ij - (q_i + p_i/rho0^2) B_i
// p_i/rho0^2 stands for a sample that mirrors the pressure of the particle that looks at it; samples with pseudo-masses
// do not [Akinci et al. 2012], there wall_pressure is 0. With the symmetric wall term it is 0 too, and B_i counts
// twice.

#include "lib/neighbours.glsl"
#include "lib/wall.glsl"

void run(uint i) {
  float q_i = load(q, i);
  precise vec2 sum = vec2(0.0);
  for_each_neighbour(i, entry) {
    sum += (q_i + load(q, load(index, entry))) * gradient_of(entry);
  }
  sum = -(params.m * sum);
  if (needs_boundary) sum -= wall_pressure_term(q_i, load(rho, i)) * load(wall_gradient, i);
  a_p[i] = sum;
}
