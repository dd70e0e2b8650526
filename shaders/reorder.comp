// Gathers ids, positions and velocities in cell order, so that neighbours in space are neighbours in memory.

void run(uint i) {
  uint from = L[i];
  id[i] = id_in[from];
  x[i] = x_in[from];
  v[i] = v_in[from];
}
