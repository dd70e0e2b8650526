// Gathers ids, positions and velocities in cell order, so that neighbours in space are neighbours in memory.

void run(uint i) {
  uint from = load(L, i);
  id[i] = load(id_in, from);
  x[i] = load(x_in, from);
  v[i] = load(v_in, from);
}
