// All that a particle needs of the boundary in this step, summed once: no later stage walks over boundary
// samples, which rest. m_b is the mass of a sample: m with a mirror boundary [Hunkler 2022, section 5.2],
// Psi_b with that of [Akinci et al. 2012].
//   wall_density = sum_b m_b W_ib        B_i = sum_b m_b dW_ib
//   wall_gradient_squares = sum_b |m dW_ib|^2, for the diagonal of the linear system with the thesis's wall
//   term
// With the symmetric wall term of the linear system B_i is twice that.
//   wall_viscosity = sum_b m_b dW_ib x_ib^T / (x_ib.x_ib + 0.01 H^2), which applied to v_i gives the viscous
//   term
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {
namespace {

/// What a particle needs of the boundary, in units of the factors in front of the sums.
template <class Real>
struct Sums {
  Real W{}, squares{};
  glm::vec<2, Real> gradient{};
  glm::vec<4, Real> tensor{};
};

template <class Real>
Sums<Real> sums_at(const State<Real>& state, const ParamsOf<Real>& params, glm::vec<2, Real> x_i) {
  const bool viscous = state.needs.laplacian, pseudo_mass = state.needs.pseudo_mass;
  Sums<Real> sums;
  for_each_row(state.C_boundary, params.columns, cell_of(params, x_i), [&](uint32_t first, uint32_t last) {
    for (uint32_t b = first; b < last; ++b) {
      const glm::vec<2, Real> x_ib = x_i - state.x_boundary[b];
      const Real r_squared = glm::dot(x_ib, x_ib);
      if (!(r_squared < params.support_squared)) continue;
      const Real r = std::sqrt(r_squared);
      const glm::vec<2, Real> dW = kernel_gradient(params, x_ib, r);
      const Real mass = pseudo_mass ? state.Psi[b] : Real(1);  // in units of params.wall_mass
      sums.W += mass * kernel(params, r);
      sums.gradient += mass * dW;
      sums.squares += glm::dot(dW, dW);
      if (viscous) {
        const glm::vec<2, Real> y = (mass * x_ib) / (r_squared + params.viscosity_floor);
        sums.tensor += glm::vec<4, Real>(dW.x * y.x, dW.x * y.y, dW.y * y.x, dW.y * y.y);
      }
    }
  });
  return sums;
}

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
  const bool viscous = state.needs.laplacian;
  const bool needs_squares = state.needs.linear_system && state.needs.thesis_wall;
  const auto write = [&](size_t i, const Sums<Real>& sums) {
    state.wall_density[i] = params.wall_mass * sums.W;
    state.wall_gradient[i] = params.wall_gradient_mass * sums.gradient;
    if (needs_squares) state.wall_gradient_squares[i] = params.m * params.m * sums.squares;
    if (viscous) state.wall_viscosity[i] = params.wall_mass * sums.tensor;
  };
  for_each_index((params.n + slice_width - 1) / slice_width, state.threads, [&](size_t slice) {
    const size_t first = slice * slice_width, last = std::min<size_t>(first + slice_width, params.n);
    if (near_boundary(state, params, first, last)) {
      for (size_t i = first; i < last; ++i) write(i, sums_at(state, params, state.x[i]));
    } else {
      for (size_t i = first; i < last; ++i) write(i, Sums<Real>{});
    }
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(boundary)
