// Pressure acceleration, symmetric in i and j [Hunkler 2022, algorithm 7; WCSPH page]. With q = p/rho^2 and
// B_i the sum over the boundary (stage `boundary`):
//   a_p = -m sum_j (q_i + q_j) dW_ij - (q_i + p_i/rho0^2) B_i
// p_i/rho0^2 stands for a sample that mirrors the pressure of the particle that looks at it; samples with
// pseudo-masses do not [Akinci et al. 2012], there wall_pressure is 0. With the symmetric wall term it is 0
// too, and B_i counts twice.
#include "cpu/neighbours.hpp"
#include "cpu/stages.hpp"
#include "cpu/wall.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void pressure_acceleration(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool walls = state.needs.boundary;
  for_each_index(params.n, state.threads, [&](size_t i) {
    const Real q_i = state.q[i];
    glm::vec<2, Real> sum{};
    for_each_neighbour(state, i, [&](uint64_t entry) {
      sum += (q_i + state.q[state.index[entry]]) * gradient_of(state, entry);
    });
    sum = -(params.m * sum);
    if (walls) sum -= wall_pressure_term(params, q_i, state.rho[i]) * state.wall_gradient[i];
    state.a_p[i] = sum;
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(pressure_acceleration)
