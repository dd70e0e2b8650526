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
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// Gives the neighbours that are too close to particle i the gradient that parts them.
template <class Real>
void push_apart(State<Real>& state, size_t i) {
  const ParamsOf<Real>& params = state.params;
  for_each_neighbour(state, i, [&](uint64_t entry) {
    const uint32_t j = state.index[entry];
    if (!(glm::length(state.x[i] - state.x[j]) < params.coincidence)) return;
    const auto dW = state.id[i] > state.id[j] ? params.parting_gradient : -params.parting_gradient;
    state.gradient[gradient_place(entry)] = dW.x;
    state.gradient[gradient_place(entry) + slice_width] = dW.y;
  });
}

}  // namespace

template <class Real>
void density(State<Real>& state) {
  const ParamsOf<Real> params = state.params;  // a copy, which no store can change
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](size_t i) {
    Real sum = kernel(params, Real(0));
    bool coincides = false;
    for_each_neighbour(state, i, [&](uint64_t entry) {
      const glm::vec<2, Real> x_ij = state.x[i] - state.x[state.index[entry]];
      const Real r = glm::length(x_ij);
      const glm::vec<2, Real> dW = kernel_gradient(params, x_ij, r);
      coincides = coincides || r < params.coincidence;
      state.gradient[gradient_place(entry)] = dW.x;
      state.gradient[gradient_place(entry) + slice_width] = dW.y;
      sum += kernel(params, r);
    });
    if (coincides) push_apart(state, i);
    sum = params.m * sum;
    if (walls) sum += state.wall_density[i];
    state.rho[i] = sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(density)
