// Sorts L within each cell by id, so that the order of all later sums depends on the state alone. The CPU inserts;
// here every particle counts those of its cell with a smaller id, all at once, and moves to that place. Of a crowd that
// no step is made of everybody stays.

void run(uint place) {
#if PASS == 0
  uint particle = L[place];
  uint id_of_particle = load(id_in, particle);
  uint first = load(C, load(cell, particle)), last = load(C, load(cell, particle) + 1u);
  uint rank = 0u;
  if (last - first > most_rounds) {
    scratch[place] = particle;
    return;
  }
  for (uint k = first; k < last; ++k) rank += uint(load(id_in, L[k]) < id_of_particle);
  scratch[first + rank] = particle;
#else
  L[place] = scratch[place];
#endif
}
