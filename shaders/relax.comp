// Relaxation of the start: x := x + a_p, each move at most 0.1 h long.

#include "lib/vectors.glsl"

void run(uint i) {
  precise vec2 move = load(a_p, i);
  float distance = length_of(move);
  if (distance > params.largest_move) move *= params.largest_move / distance;
  precise vec2 x_next = load(x, i) + move;
  x_in[i] = x_next;
  v_in[i] = load(v, i);
}
