// Puts every particle into its cell in L, moving C from the cells' ends to their beginnings
// [Hunkler 2022, algorithm 3]. The order within a cell is left to chance; grid_order settles it.

void run(uint i) {
  uint place = atomicAdd(C[load(cell, i)], 0xffffffffu) - 1u;
  L[place] = i;
}
