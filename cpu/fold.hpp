// Reductions in a fixed order: values are summed in groups of 64, these sums in groups of 64, and so on. The
// result does not depend on threads, and a machine that works group by group gets the same bits.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Folds values[0 .. count) with `join`.
template <class Real, class Join>
Real fold(const Real* values, uint64_t count, Join join) {
  uint64_t group = 1;
  while (group * chunk_width < count) group *= chunk_width;
  Real result{};
  for (uint64_t first = 0; first < count; first += group) {
    const Real part = group == 1 ? values[first] : fold(values + first, std::min(group, count - first), join);
    result = first == 0 ? part : join(result, part);
  }
  return result;
}

}  // namespace sluice::cpu::SLUICE_SET
