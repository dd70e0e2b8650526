// IISPH: change of density by the pressure accelerations, the operator applied to p [Hunkler 2022, eq. 5.19]:
//   (Ap)_i = dt^2 ( m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i )

#include "lib/neighbours.glsl"
#include "lib/vectors.glsl"

void run(uint i) {
  vec2 a_i = load(a_p, i);
  precise float sum = 0.0;
  for_each_neighbour(i, entry) {
    precise vec2 a_ij = a_i - load(a_p, load(index, entry));
    sum += dot_of(a_ij, gradient_of(entry));
  }
  sum = params.m * sum;
  if (needs_boundary) sum += dot_of(a_i, load(wall_gradient, i));
  sum = (params.dt * params.dt) * sum;
  Ap[i] = sum;
}
