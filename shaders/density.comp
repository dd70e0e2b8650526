// Density by summation over the neighbours, the particle itself and the boundary [Hunkler 2022, algorithm 5]:
//   rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib
// and on the way the kernel gradient dW_ij of every entry of the neighbour list [Hunkler 2022, eq. 5.2].
//
// Differs from [Hunkler 2022]: particles closer than 1e-4 h are pushed apart along a fixed direction, see
// cpu/density.cpp.

#include "lib/kernel.glsl"
#include "lib/neighbours.glsl"

// Looked for apart, so that nobody loads ids who doesn't need them.
void part(uint i, vec2 x_i) {
  uint id_i = load(id, i);
  for_each_neighbour(i, entry) {
    uint j = load(index, entry);
    precise vec2 x_ij = x_i - load(x, j);
    if (length_of(x_ij) < params.coincidence) {
      vec2 dW = id_i > load(id, j) ? params.parting_gradient : -params.parting_gradient;
      uint block = 2u * entry - entry % slice_width;
      gradient[block] = dW.x;
      gradient[block + slice_width] = dW.y;
    }
  }
}

void run(uint i) {
  vec2 x_i = load(x, i);
  precise float sum = kernel(0.0);
  bool coincides = false;
  for_each_neighbour(i, entry) {
    precise vec2 x_ij = x_i - load(x, load(index, entry));
    float r = length_of(x_ij);
    vec2 dW = kernel_gradient(x_ij, r);
    coincides = coincides || r < params.coincidence;
    uint block = 2u * entry - entry % slice_width;
    gradient[block] = dW.x;
    gradient[block + slice_width] = dW.y;
    sum += kernel(r);
  }
  if (coincides) part(i, x_i);
  sum = params.m * sum + (needs_boundary ? load(wall_density, i) : 0.0);
  rho[i] = sum;
}
