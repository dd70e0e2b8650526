// Cell of every particle, and how many there are in each: the first pass over the thesis's array C
// [Hunkler 2022, algorithm 3; Lagae and Dutre 2008].

#include "lib/grid.glsl"

void run(uint i) {
#if PASS == 0
  C[i] = 0u;  // one invocation per cell
#else
  uint here = cell_of(load(x_in, i));
  cell[i] = here;
  atomicAdd(C[here], 1u);
#endif
}
