// IISPH: diagonal of the pressure system with respect to q = p/rho^2 [Hunkler 2022, eq. 5.13]:
//   A_ii = -dt^2 ( |m sum_j dW_ij + B_i|^2 + sum |m dW|^2 )
// With the wall term of the thesis the sum of squares is over fluid and mirror samples alike; otherwise samples have no
// part in it.

#include "lib/neighbours.glsl"
#include "lib/vectors.glsl"

void run(uint i) {
  precise vec2 sum = vec2(0.0);
  precise float squares = 0.0;
  for_each_neighbour(i, entry) {
    vec2 dW = gradient_of(entry);
    sum += dW;
    squares += dot_of(dW, dW);
  }
  sum = params.m * sum;
  squares = params.m * params.m * squares;
  if (needs_boundary) sum += load(wall_gradient, i);
  if (needs_thesis_wall) squares += load(wall_gradient_squares, i);
  precise float diagonal = -(params.dt * params.dt) * (dot_of(sum, sum) + squares);
  A_ii[i] = diagonal;
}
