// IISPH: diagonal of the pressure system [Hunkler 2022, eq. 5.13]:
//   A_ii = -dt^2/rho_i^2 ( |m sum_j dW_ij + B_i|^2 + sum |m dW|^2 )
// The sum of squares is over fluid and mirror samples alike. Samples with pseudo-masses have no part in it:
// they do not answer to pressure with a pressure of their own [Ihmsen et al. 2014]. Differs from [Hunkler
// 2022, eq. 5.13]: printed there with separate inner sums for fluid and boundary; one sum over all
// neighbours, as in algorithm 6, is what gives the published iteration counts.
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu {

template <class Real>
void diagonal(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary, mirror = walls && !state.needs.pseudo_mass;
  const auto term = [](auto, auto, auto dW) { return std::array{dW.x, dW.y, dot(dW, dW)}; };
  sum_over_neighbours(state, std::array<Real, 3>{}, term, [&](uint32_t i, auto sums) {
    glm::vec<2, Real> sum = params.m * glm::vec<2, Real>(sums[0], sums[1]);
    Real squares = params.m * params.m * sums[2];
    if (walls) sum += state.wall_gradient[i];
    if (mirror) squares += state.wall_gradient_squares[i];
    const Real scale = params.dt / state.rho[i];
    state.A_ii[i] = -(scale * scale) * (glm::dot(sum, sum) + squares);
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(diagonal)
