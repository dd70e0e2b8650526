// One level of the reduction in cpu/fold.hpp: values in groups of 64, each group summed from its first value on. The
// first level reads the stage's own sums (VALUES), the others what the level before left in scratch. Several arrays
// of `fold_length` values each, one behind the other, are folded beside each other.

float value_to_fold(uint array, uint k) {
  uint at = array * fold_length + k;
  return fold_first != 0u ? VALUES[at] : uintBitsToFloat(scratch[fold_from + at]);
}

float fold_group(uint array, uint group, bool largest) {
  uint first = group * chunk_width;
  uint last = min(first + chunk_width, fold_length);
  precise float result = value_to_fold(array, first);
  for (uint k = first + 1u; k < last; ++k) {
    float value = value_to_fold(array, k);
    if (largest)
      result = larger(result, value);
    else
      result += value;
  }
  return result;
}

/// Folds the group that this invocation stands for into scratch.
void fold_into_scratch(uint invocation, bool largest) {
  uint groups = (fold_length + chunk_width - 1u) / chunk_width;
  uint array = invocation / groups;
  scratch[fold_to + invocation] = floatBitsToUint(fold_group(array, invocation % groups, largest));
}
