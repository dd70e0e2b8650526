// The rows of the stage table.
#include "core/model/stages.hpp"

#include "core/scene/scene.hpp"

namespace sluice {
namespace {

constexpr bool always(const Needs&) { return true; }
constexpr bool boundary(const Needs& needs) { return needs.boundary; }
constexpr bool pseudo_mass(const Needs& needs) { return needs.pseudo_mass; }
constexpr bool laplacian(const Needs& needs) { return needs.laplacian; }
constexpr bool xsph(const Needs& needs) { return needs.xsph; }
constexpr bool tait(const Needs& needs) { return needs.tait; }
constexpr bool state_equation(const Needs& needs) { return needs.state_equation; }
constexpr bool linear_system(const Needs& needs) { return needs.linear_system; }
constexpr bool relaxation(const Needs& needs) { return needs.relaxation; }

using enum Field;

constexpr FieldSet neighbour_list{list, index, gradient};
constexpr FieldSet wall_fields{wall_density, wall_gradient, wall_gradient_squares, wall_viscosity};

}  // namespace

const std::array<StageInfo, stage_count>& stage_table() {
  // clang-format off
  static const std::array<StageInfo, stage_count> table = {{
      {"pseudo_mass", {C_boundary, x_boundary}, {Psi}, Length::boundary, pseudo_mass,
       "Psi_b = rho0 / sum_l W_bl"},
      {"grid_count", {x_in}, {cell, C}, Length::fluid, always,
       "C[c] = number of particles in cell c"},
      {"grid_scan", {C}, {C}, Length::cells, always,
       "C[c] := C[0] + ... + C[c]"},
      {"grid_scatter", {cell, C}, {C, L}, Length::fluid, always,
       "C[c] := C[c] - 1, L[C[c]] = i"},
      {"grid_order", {cell, C, L, id_in}, {L}, Length::cells, always,
       "L within each cell by id"},
      {"reorder", {L, id_in, x_in, v_in}, {id, x, v}, Length::fluid, always,
       "x_i = x_in[L[i]], ..."},
      {"neighbours", {x, C}, {list, index, list_needed}, Length::fluid, always,
       "j: |x_ij| < 2H"},
      {"boundary", {x, C_boundary, x_boundary, Psi}, wall_fields, Length::fluid, boundary,
       "sum_b m_b W_ib, B_i = sum_b m_b dW_ib, ..."},
      {"density", {id, x, list, index, wall_density}, {rho, gradient}, Length::fluid, always,
       "rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib, and dW_ij"},
      {"clamp_density", {rho}, {rho}, Length::fluid, tait,
       "rho := max(rho, rho0)"},
      {"external", {x}, {a_n}, Length::fluid, always,
       "a_n = g - c (x - centre)"},
      {"viscosity", neighbour_list | FieldSet{x, v, rho, wall_viscosity, a_n}, {a_n}, Length::fluid, laplacian,
       "a_n += 2 nu sum (m/rho_j) (v_ij.x_ij)/(x_ij.x_ij + 0.01 H^2) dW_ij"},
      {"xsph", {list, index, x, v, rho, a_n}, {a_n}, Length::fluid, xsph,
       "a_n -= (alpha/dt) m sum_j (v_ij/rho_j) W_ij"},
      {"predict", {v, a_n}, {v_star}, Length::fluid, always,
       "v* = v + dt a_n"},
      {"state_equation", {rho}, {p, q}, Length::fluid, state_equation,
       "p = max(k (rho/rho0 - 1), 0)"},
      {"tait", {rho}, {p, q}, Length::fluid, tait,
       "p = kappa rho0/gamma ((rho/rho0)^gamma - 1)"},
      {"diagonal", {list, gradient, wall_gradient, wall_gradient_squares}, {A_ii}, Length::fluid,
       linear_system,
       "A_ii = -dt^2 (|m sum_j dW + B_i|^2 + sum |m dW|^2)"},
      {"source", neighbour_list | FieldSet{v_star, rho, wall_gradient}, {s}, Length::fluid, linear_system,
       "s_i = w (rho0 - rho_i) - dt m sum v*_ij.dW_ij"},
      {"warm_start", {L, p_in, rho}, {q}, Length::fluid, linear_system,
       "q = warm_start p/rho^2, with p of the last step"},
      {"pressure_acceleration", neighbour_list | FieldSet{q, rho, wall_gradient}, {a_p}, Length::fluid, always,
       "a_p = -m sum_j (q_i + q_j) dW_ij - (q_i [+ p_i/rho0^2: mirror]) B_i"},
      {"pressure_operator", neighbour_list | FieldSet{a_p, wall_gradient}, {Ap}, Length::fluid, linear_system,
       "Ap = dt^2 (m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i)"},
      {"residual", {Ap, s, A_ii, q, q_before, Ap_before}, {residual_sums}, Length::fluid, linear_system,
       "sums of |s - Ap|, (s - Ap)^2, ... per chunk"},
      {"stop_test", {residual_sums, sweeps, solve}, {solve, sweeps}, Length::one, linear_system,
       "e, whether the system is solved, and the step t"},
      {"pressure_update", {Ap, s, A_ii, q, q_best, solve}, {q, q_best, q_before, Ap_before}, Length::fluid,
       linear_system,
       "q := max(q + t (s - Ap)/A_ii, 0)"},
      {"pressure", {q, rho}, {p}, Length::fluid, linear_system,
       "p = q rho^2"},
      {"integrate", {x, v_star, a_p}, {x_in, v_in}, Length::fluid, always,
       "v = v* + dt a_p, x = x + dt v"},
      {"relax", {x, v, a_p}, {x_in, v_in}, Length::fluid, relaxation,
       "x := x + a_p, moved by at most 0.1 h"},
      {"diagnostics", {x_in, v_in, v, rho, q, wall_gradient}, {diagnostic_sums}, Length::fluid, always,
       "sums and largest values per chunk"},
      {"totals", {diagnostic_sums}, {Field::totals}, Length::diagnostics, always,
       "the same over all chunks"},
  }};
  // clang-format on
  return table;
}

const StageInfo& info(Stage stage) { return stage_table()[static_cast<uint32_t>(stage)]; }

Needs needs_of(const Scene& scene) {
  Needs needs;
  needs.boundary = scene.boundary_model != BoundaryModel::none && !scene.boundary.empty();
  needs.pseudo_mass = needs.boundary && scene.boundary_model == BoundaryModel::akinci;
  needs.laplacian = scene.viscosity_model == ViscosityModel::laplacian && scene.viscosity > 0;
  needs.xsph = scene.viscosity_model == ViscosityModel::xsph && scene.viscosity > 0;
  needs.state_equation = scene.method == PressureMethod::ssph;
  needs.tait = scene.method == PressureMethod::wcsph;
  needs.linear_system = scene.method == PressureMethod::iisph;
  needs.thesis_wall =
      needs.boundary && scene.boundary_model == BoundaryModel::mirror && scene.iisph.wall == Wall::thesis;
  needs.barzilai_borwein = scene.iisph.solver == Solver::barzilai_borwein;
  needs.relaxation = scene.relax > 0;
  return needs;
}

namespace {

/// Without boundary there are no wall fields; some belong to one model only.
FieldSet needed_only(FieldSet set, const Needs& needs) {
  FieldSet kept;
  for (uint32_t i = 0; i < field_count; ++i) {
    const Field field = static_cast<Field>(i);
    const bool wall_without_boundary = wall_fields.has(field) && !needs.boundary;
    const bool unused = (field == wall_viscosity && !needs.laplacian) ||
                        (field == wall_gradient_squares && !(needs.linear_system && needs.thesis_wall)) ||
                        ((field == q_before || field == Ap_before) && !needs.barzilai_borwein) ||
                        (field == Psi && !needs.pseudo_mass);
    if (set.has(field) && !wall_without_boundary && !unused) kept = kept | FieldSet{field};
  }
  return kept;
}

}  // namespace

FieldSet reads_of(Stage stage, const Needs& needs) { return needed_only(info(stage).reads, needs); }
FieldSet writes_of(Stage stage, const Needs& needs) { return needed_only(info(stage).writes, needs); }

}  // namespace sluice
