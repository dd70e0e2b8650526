// Positions put through the search stages of the CPU backend, and the neighbours they have by all-pairs
// distance.
#pragma once

#include <set>
#include <vector>

#include "cpu/stages.hpp"
#include "sluice/scene.hpp"

namespace sluice::test {

/// `n` positions, uniform in a box.
std::vector<Vec2> random_positions(uint32_t n, Vec2 min, Vec2 max, uint64_t seed);

/// Neighbours of all particles together.
uint64_t total(const std::vector<std::set<uint32_t>>& sets);

/// A square domain of `cells` support lengths with spacing 1 and H = smoothing, holding no shapes.
Scene open_scene(double cells, double smoothing = 1);

/// State after grid, reorder, neighbours and density for these positions, ids in order.
template <class Real>
cpu::State<Real> searched(const Scene& scene, const std::vector<Vec2>& positions, int threads = 1,
                          uint64_t list_entries = 0);

/// Calls f(j, dW_ij) for the neighbours j of particle i, in the order of the list.
template <class Real, class F>
void for_each_neighbour(const cpu::State<Real>& state, uint32_t i, F&& f) {
  const uint64_t first = state.list[i].x;
  const uint64_t lane = first % slice_width;
  for (uint32_t k = 0; k < state.list[i].y; ++k) {
    const uint64_t entry = first + uint64_t{slice_width} * k;
    const uint64_t block = 2 * entry - lane;
    f(state.index[entry], glm::vec<2, Real>(state.gradient[block], state.gradient[block + slice_width]));
  }
}

/// Neighbour ids of each particle, by id.
template <class Real>
std::vector<std::set<uint32_t>> neighbour_sets(const cpu::State<Real>& state);

/// Neighbours found by comparing all pairs in Real arithmetic.
template <class Real>
std::vector<std::set<uint32_t>> all_pairs(const Scene& scene, const std::vector<Vec2>& positions);

}  // namespace sluice::test
