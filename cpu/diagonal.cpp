// IISPH: diagonal of the pressure system with respect to q = p/rho^2 [Hunkler 2022, eq. 5.13, which is that
// with respect to p and has a further 1/rho_i^2]:
//   A_ii = -dt^2 ( |m sum_j dW_ij + B_i|^2 + sum |m dW|^2 )
// With the wall term of the thesis the sum of squares is over fluid and mirror samples alike. Otherwise
// samples have no part in it: they do not answer to pressure with a pressure of their own [Ihmsen et al.
// 2014], and this is the exact diagonal of the operator. Differs from [Hunkler 2022, eq. 5.13]: printed there
// with separate inner sums for fluid and boundary; one sum over all neighbours, as in algorithm 6, is what
// gives the published iteration counts.
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void diagonal(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary, thesis_wall = state.needs.thesis_wall;
  for_each_index(params.n, state.threads, [&](size_t i) {
    glm::vec<2, Real> sum{};
    Real squares{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      const glm::vec<2, Real> dW = gradient_of(state, entry);
      sum += dW;
      squares += glm::dot(dW, dW);
    });
    sum = params.m * sum;
    squares = params.m * params.m * squares;
    if (walls) sum += state.wall_gradient[i];
    if (thesis_wall) squares += state.wall_gradient_squares[i];
    state.A_ii[i] = -(params.dt * params.dt) * (glm::dot(sum, sum) + squares);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(diagonal)
