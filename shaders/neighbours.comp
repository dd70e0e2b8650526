// The neighbours of every particle, r < 2H, in ascending order [Hunkler 2022, algorithm 4]. In three passes: the lengths
// of all lists; a place for each slice of 16 particles, as long as its longest list; and the entries. Where a slice
// stands is left to chance, what is in it is not. When the places do not suffice, list_needed says how many would, and
// all lists are left empty.

#include "lib/grid.glsl"
#include "lib/vectors.glsl"

const uint crowded = 0xffffffffu;

#if PASS == 0

void run(uint i) {
  if (i == 0u) {
    list_needed[0] = 0u;
    scratch[0] = 0u;
  }
  vec2 x_i = load(x, i);
  uint middle = cell_of(x_i);
  uint found = 0u, candidates = 0u;
  for (uint row = 0u; row < 3u; ++row) {
    uint first = load(C, middle + row * params.columns - params.columns - 1u);
    uint last = load(C, middle + row * params.columns - params.columns + 2u);
    candidates += last - first;
    if (candidates > most_rounds) break;
    for (uint j = first; j < last; ++j) {
      precise vec2 x_ij = x_i - load(x, j);
      found += uint(dot_of(x_ij, x_ij) < params.support_squared) & uint(j != i);
    }
  }
  list[i] = uvec2(0u, candidates > most_rounds ? crowded : found);
}

#elif PASS == 1

void run(uint slice) {
  uint first = slice * slice_width, last = min(first + slice_width, params.n);
  uint longest = 0u;
  for (uint i = first; i < last; ++i) longest = max(longest, list[i].y);
  uint needed = longest == crowded ? 0u : slice_width * longest;
  uint place = atomicAdd(list_needed[0], needed);
  if (longest == crowded || place + needed < place) atomicMax(scratch[0], 1u);
  for (uint i = first; i < last; ++i) list[i].x = place + i - first;
}

#else

void run(uint i) {
  bool beyond_bounds = scratch[0] != 0u;
  if (beyond_bounds || list_needed[0] > list_size) {
    list[i].y = 0u;
    if (i == 0u && beyond_bounds) list_needed[0] = list_beyond_bounds;
    return;
  }
  vec2 x_i = load(x, i);
  uint middle = cell_of(x_i);
  uint entry = list[i].x;
  for (uint row = 0u; row < 3u; ++row) {
    uint first = load(C, middle + row * params.columns - params.columns - 1u);
    uint last = load(C, middle + row * params.columns - params.columns + 2u);
    for (uint j = first; j < last; ++j) {
      precise vec2 x_ij = x_i - load(x, j);
      precise float r_squared = dot_of(x_ij, x_ij);
      if (!(r_squared < params.support_squared) || j == i) continue;
      index[entry] = j;
      entry += slice_width;
    }
  }
}

#endif
