// The neighbour list of a particle; twin of shaders/lib/neighbours.glsl.
#pragma once

#include "cpu/instructions.hpp"

namespace sluice::cpu::SLUICE_SET {

/// Calls f(entry) for the entries of particle i's list, in order: state.index[entry] is a neighbour.
template <class Real, class F>
void for_each_neighbour(const State<Real>& state, size_t i, const F& f) {
  const glm::uvec2 list = state.list[i];
  uint64_t entry = list.x;
  for (uint32_t k = 0; k < list.y; ++k, entry += slice_width) f(entry);
}

/// Where the x component of an entry's kernel gradient stands, slice_width before the y component.
inline uint64_t gradient_place(uint64_t entry) { return 2 * entry - entry % slice_width; }

template <class Real>
glm::vec<2, Real> gradient_of(const State<Real>& state, uint64_t entry) {
  const uint64_t place = gradient_place(entry);
  return {state.gradient[place], state.gradient[place + slice_width]};
}

}  // namespace sluice::cpu::SLUICE_SET
