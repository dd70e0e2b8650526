// Density by summation over the neighbours, the particle itself and the boundary [Hunkler 2022, algorithm 5]:
//   rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib
// and on the way the kernel gradient dW_ij of every entry of the neighbour list [Hunkler 2022, eq. 5.2]:
// every later sum over neighbours takes it from there, a pressure sweep twice.
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

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
      sum += those(there, kernel(params, r));
    });
    auto rho = params.m * sum;
    if (walls) rho += i(state.wall_density);
    i.set(state.rho, rho);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(density)
