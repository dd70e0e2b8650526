// Inclusive prefix sum of C: afterwards C[c] is the end of cell c in L [Hunkler 2022, algorithm 3]. In three passes:
// sums of blocks of cells, their exclusive prefix sum by a single group, and the prefix sums within the blocks. An
// invocation takes `scan_width` cells, a group one block [Blelloch 1990].

shared uint prefix[group_size];

/// Sum of `value` over the invocations of the group before this one.
uint exclusive_in_group(uint value) {
  uint lane = gl_LocalInvocationIndex;
  prefix[lane] = value;
  barrier();
  for (uint reach = 1u; reach < group_size; reach *= 2u) {
    uint below = lane >= reach ? prefix[lane - reach] : 0u;
    barrier();
    prefix[lane] += below;
    barrier();
  }
  return prefix[lane] - value;
}

uint sum_of_cells(uint first) {
  uint sum = 0u;
  for (uint k = 0u; k < scan_width; ++k) sum += first + k < count ? C[first + k] : 0u;
  return sum;
}

void run_group(uint block) {
  uint lane = gl_LocalInvocationIndex;
#if PASS == 0
  uint sum = sum_of_cells((block * group_size + lane) * scan_width);
  uint before = exclusive_in_group(sum);
  if (lane == group_size - 1u && block * group_size * scan_width < count) scratch[block] = before + sum;
#elif PASS == 1
  // `count` blocks; each invocation takes a run of them.
  uint share = (count + group_size - 1u) / group_size;
  uint first = min(lane * share, count), last = min(first + share, count);
  uint sum = 0u;
  for (uint k = first; k < last; ++k) sum += scratch[k];
  uint running = exclusive_in_group(sum);
  for (uint k = first; k < last; ++k) {
    uint own = scratch[k];
    scratch[k] = running;
    running += own;
  }
#else
  uint first = (block * group_size + lane) * scan_width;
  uint running = exclusive_in_group(sum_of_cells(first));
  if (first >= count) return;
  running += scratch[block];
  for (uint k = first; k < min(first + scan_width, count); ++k) {
    running += C[k];
    C[k] = running;
  }
#endif
}
