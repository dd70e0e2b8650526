// Density and kernel gradients, as many particles side by side as fit into a register.
#include "cpu/kernel.hpp"
#include "cpu/simd/sums.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

namespace {

/// Replaces the gradients of those lanes of `close` whose particles are neighbours too close to each other.
/// A lane whose list has ended may hold its own particle.
template <class Real>
[[gnu::noinline]] void push_apart(State<Real>& state, size_t first, const Indices<Real>& neighbours,
                                  uint32_t close, uint64_t block) {
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
        push_apart(state, i.first, j.at, close, block);
      sum += select(there, kernel(params, r), Vector<Real>{});
    });
    auto rho = params.m * sum;
    if (walls) rho += i(state.wall_density);
    i.set(state.rho, rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(density)
