// The entries of diagnostics over all chunks: sums, and the largest of the largest.

#include "lib/vectors.glsl"

#define VALUES diagnostic_sums
#include "lib/fold.glsl"

void run(uint i) {
#if PASS == 0
  uint groups = (fold_length + chunk_width - 1u) / chunk_width;
  fold_into_scratch(i, i / groups >= first_max_total);
#else
  totals[i] = fold_group(i, 0u, i >= first_max_total);
#endif
}
