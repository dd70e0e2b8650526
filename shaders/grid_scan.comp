// Inclusive prefix sum of C: afterwards C[c] is the end of cell c in L [Hunkler 2022, algorithm 3]. In three passes: the
// sums of runs of cells, the exclusive prefix sums of these by a single group, and the prefix sums within the runs
// [Blelloch 1990]. An invocation takes a run of `scan_width` cells.

#if PASS == 0

void run(uint i) {
  uint sum = 0u;
  for (uint c = i * scan_width; c < min((i + 1u) * scan_width, cells); ++c) sum += C[c];
  scratch[i] = sum;
}

#elif PASS == 1

shared uint sums[group_size];

// `count` runs; each invocation takes as many of them in a row as it must.
void run_group(uint group) {
  uint lane = gl_LocalInvocationIndex;
  uint share = (count + group_size - 1u) / group_size;
  uint first = min(lane * share, count), last = min(first + share, count);
  uint sum = 0u;
  for (uint k = first; k < last; ++k) sum += scratch[k];
  sums[lane] = sum;
  barrier();
  uint running = 0u;
  for (uint before = 0u; before < lane; ++before) running += sums[before];
  for (uint k = first; k < last; ++k) {
    uint own = scratch[k];
    scratch[k] = running;
    running += own;
  }
}

#else

void run(uint i) {
  uint running = scratch[i];
  for (uint c = i * scan_width; c < min((i + 1u) * scan_width, cells); ++c) {
    running += C[c];
    C[c] = running;
  }
}

#endif
