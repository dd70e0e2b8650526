// The kernel gradient of every entry of the neighbour list [Hunkler 2022, eq. 5.2].

#include "lib/kernel.glsl"
#include "lib/neighbours.glsl"

void run(uint i) {
  vec2 x_i = load(x, i);
  for_each_neighbour(i, entry) {
    precise vec2 x_ij = x_i - load(x, load(index, entry));
    vec2 dW = kernel_gradient(x_ij, length_of(x_ij));
    uint block = 2u * entry - entry % slice_width;
    gradient[block] = dW.x;
    gradient[block + slice_width] = dW.y;
  }
}
