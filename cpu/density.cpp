// Density by summation over the neighbours, the particle itself and the boundary [Hunkler 2022, algorithm 5]:
//   rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib
// and on the way the kernel gradient dW_ij of every entry of the neighbour list [Hunkler 2022, eq. 5.2]:
// every later sum over neighbours takes it from there, a pressure sweep twice.
//
// Differs from [Hunkler 2022]: the gradient of the kernel vanishes where particles coincide, and no pressure
// could part them. Those closer than 1e-4 h get the steepest gradient that the kernel has, that of q = 2/3,
// along a fixed direction: the particle with the larger id as if it stood ahead in that direction, the other
// one as if behind. So they part the same way in every run, and momentum is conserved.
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

namespace {

/// Replaces the gradients of those lanes of `close` whose particles are neighbours too close to each other.
/// A lane whose list has ended may hold its own particle.
template <class Real>
[[gnu::noinline]] void part(State<Real>& state, size_t first, const Indices<Real>& neighbours, uint32_t close,
                            uint64_t block) {
  for (uint32_t lane = 0; lane < lane_count<Real>; ++lane) {
    const size_t i = first + lane;
    const uint32_t j = neighbours[lane];
    if ((close >> lane & 1) == 0 || i == j || i >= state.params.n) continue;
    const auto dW =
        state.id[i] > state.id[j] ? state.params.parting_gradient : -state.params.parting_gradient;
    state.gradient[block + lane] = dW.x;
    state.gradient[block + slice_width + lane] = dW.y;
  }
}

}  // namespace

template <class Real>
void density(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const bool walls = state.needs.boundary;
  for_each_group(state, [&](const auto& i) {
    const Pair<Vector<Real>> x_i = i(state.x);
    Vector<Real> sum = broadcast(kernel(params, Real(0)));
    walk(state, i, [&](uint64_t block, const Particles<Real>& j, auto there) {
      const auto x_ij = x_i - by_lane::gather(state.x.data(), j.at);  // a gather would wait for the stores
      const auto r = square_root(dot(x_ij, x_ij));
      const auto slope = kernel_slope(params, r);
      store(slope * x_ij.x, &state.gradient[block]);
      store(slope * x_ij.y, &state.gradient[block + slice_width]);
      const uint32_t close = bits_below(r, params.coincidence);
      if (close != 0) [[unlikely]]
        part(state, i.first, j.at, close, block);
      sum += those(there, kernel(params, r));
    });
    auto rho = params.m * sum;
    if (walls) rho += i(state.wall_density);
    i.set(state.rho, rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(density)
