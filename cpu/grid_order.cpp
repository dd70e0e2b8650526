// Sorts L within each cell by id, so that the order of all later sums depends on the state alone and not on
// who came first to a counter. Differs from [Hunkler 2022, algorithm 3]: there the order within a cell is
// that of insertion.
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

namespace {

/// Particles of a cell up to which insertion is fast whatever their order is.
constexpr uint32_t few = 64;

/// Sorts places first to last - 1, which hold hardly anything out of order.
template <class Real>
void sort_places(State<Real>& state, uint32_t first, uint32_t last) {
  if (last - first > most_rounds) return;  // no step is made of such a crowd
  if (last - first > few) {
    std::sort(state.L.begin() + first, state.L.begin() + last,
              [&](uint32_t a, uint32_t b) { return state.id_in[a] < state.id_in[b]; });
    return;
  }
  for (uint32_t place = first + 1; place < last; ++place) {
    const uint32_t particle = state.L[place];
    uint32_t hole = place;
    while (hole > first && state.id_in[state.L[hole - 1]] > state.id_in[particle]) {
      state.L[hole] = state.L[hole - 1];
      --hole;
    }
    state.L[hole] = particle;
  }
}

}  // namespace

template <class Real>
void grid_order(State<Real>& state) {
  // Threads share the particles, not the cells: most of these are empty where the fluid lies at the bottom.
  const auto cell_at = [&](size_t place) {
    return std::lower_bound(state.C.begin(), state.C.end(), static_cast<uint32_t>(place)) - state.C.begin();
  };
  for_each_part(state, [&](Range part) {
    const auto end = static_cast<size_t>(cell_at(part.last));
    for (auto cell = static_cast<size_t>(cell_at(part.first)); cell < end; ++cell)
      sort_places(state, state.C[cell], state.C[cell + 1]);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(grid_order)
