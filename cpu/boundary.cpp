// All that a particle needs of the boundary in this step, summed once: no later stage walks over boundary
// samples. Mirror boundary: every sample has mass m and rests [Hunkler 2022, section 5.2].
//   wall_density = m sum_b W_ib        B_i = m sum_b dW_ib        wall_gradient_squares = sum_b |m dW_ib|^2
//   wall_viscosity = m sum_b dW_ib x_ib^T / (x_ib.x_ib + 0.01 H^2), which applied to v_i gives the viscous
//   term
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu {

template <class Real>
void boundary(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  const bool viscous = state.needs.laplacian, linear_system = state.needs.linear_system;
  for_each_index(params.n, state.threads, [&](uint32_t i) {
    const glm::vec<2, Real> x_i = state.x[i];
    Real W{}, squares{};
    glm::vec<2, Real> gradient{};
    glm::vec<4, Real> tensor{};
    for_each_row(state.C_boundary, params.columns, cell_of(params, x_i), [&](uint32_t first, uint32_t last) {
      for (uint32_t b = first; b < last; ++b) {
        const glm::vec<2, Real> x_ib = x_i - state.x_boundary[b];
        const Real r_squared = glm::dot(x_ib, x_ib);
        if (!(r_squared < params.support_squared)) continue;
        const Real r = std::sqrt(r_squared);
        const glm::vec<2, Real> dW = kernel_gradient(params, x_ib, r);
        W += kernel(params, r);
        gradient += dW;
        squares += glm::dot(dW, dW);
        if (viscous) {
          const glm::vec<2, Real> y = x_ib / (r_squared + params.viscosity_floor);
          tensor += glm::vec<4, Real>(dW.x * y.x, dW.x * y.y, dW.y * y.x, dW.y * y.y);
        }
      }
    });
    state.wall_density[i] = params.m * W;
    state.wall_gradient[i] = params.m * gradient;
    if (linear_system) state.wall_gradient_squares[i] = params.m * params.m * squares;
    if (viscous) state.wall_viscosity[i] = params.m * tensor;
  });
}

}  // namespace sluice::cpu

SLUICE_INSTANTIATE_STAGE(boundary)
