// IISPH: change of density by the pressure accelerations, the operator applied to p [Hunkler 2022, eq. 5.19]:
//   (Ap)_i = dt^2 ( m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i )
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_operator(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const glm::vec<2, Real> a_i = state.a_p[i];
    Real sum{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      sum += glm::dot(a_i - state.a_p[state.index[entry]], gradient_of(state, entry));
    });
    sum = params.m * sum;
    if (walls) sum += glm::dot(a_i, state.wall_gradient[i]);
    state.Ap[i] = (params.dt * params.dt) * sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pressure_operator)
