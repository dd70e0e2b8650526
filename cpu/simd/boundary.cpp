// The boundary's part, with slices of particles passed over where no boundary sample is in reach: most of
// them.
#include "cpu/simd/instructions.hpp"
#include "cpu/stages.hpp"
#include "cpu/wall_sums.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// Whether any boundary sample may be in reach of particles first to last - 1. They stand in the order of
/// their cells, so all of these are between the first one's and the last one's.
template <class Real>
bool near_boundary(const State<Real>& state, const ParamsOf<Real>& params, size_t first, size_t last) {
  const auto& C = state.C_boundary;
  const uint32_t begin = cell_of(params, state.x[first]), end = cell_of(params, state.x[last - 1]);
  const auto samples = [&](uint32_t from, uint32_t to) { return C[to + 2] - C[from - 1]; };
  const uint32_t columns = params.columns;
  return (samples(begin - columns, end - columns) | samples(begin, end) |
          samples(begin + columns, end + columns)) != 0;
}

}  // namespace

template <class Real>
void boundary(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const auto set = wall_sums_setter(state, params);
  for_each_index((params.n + slice_width - 1) / slice_width, state.threads, [&](size_t slice) {
    const size_t first = slice * slice_width, last = std::min<size_t>(first + slice_width, params.n);
    if (near_boundary(state, params, first, last)) {
      for (size_t i = first; i < last; ++i) set(i, wall_sums_at(state, params, state.x[i]));
    } else {
      for (size_t i = first; i < last; ++i) set(i, WallSums<Real>{});
    }
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(boundary)
