// THE table of stages: what a simulation step is made of, in the order of a step. A stage is a row here, a
// function in cpu/<stage>.cpp, a shader shaders/<stage>.comp and its equation in docs/model.md. Plans, the
// checks of shaders and the tests of agreement follow from the rows.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "core/model/fields.hpp"
#include "core/model/needs.hpp"

namespace sluice {

/// Elements of an enum that ends with `count`, as a set.
template <class Element>
class SetOf {
 public:
  constexpr SetOf() = default;
  constexpr SetOf(std::initializer_list<Element> elements) {
    for (const Element element : elements) bits_ |= uint64_t{1} << static_cast<uint32_t>(element);
  }
  constexpr bool has(Element element) const { return (bits_ >> static_cast<uint32_t>(element)) & 1u; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr SetOf operator|(SetOf other) const { return SetOf(bits_ | other.bits_); }

 private:
  constexpr explicit SetOf(uint64_t bits) : bits_(bits) {}
  static_assert(static_cast<uint32_t>(Element::count) <= 64);
  uint64_t bits_ = 0;
};
using FieldSet = SetOf<Field>;

/// How often a phase runs.
enum class Runs { once, each_step, until_solved };

// clang-format off
/// PHASE(name, how often it runs, need, title). A step runs its phases in this order.
#define SLUICE_PHASES(PHASE)                                                                      \
  PHASE(once, once, always, "before the first step")                                              \
  PHASE(sort, each_step, always, "grid")                                                          \
  PHASE(search, each_step, always, "neighbours and density")                                      \
  PHASE(forces, each_step, always, "forces")                                                      \
  PHASE(sweep, until_solved, linear_system, "sweep, repeated until the pressure has converged")   \
  PHASE(finish, each_step, always, "finish")

/// STAGE(name, phases, fields it reads, fields it writes, what one invocation works on, need, tasks it is part of,
/// equation in short). docs/model.md has the equation with its source.
#define SLUICE_STAGES(STAGE)                                                                                            \
  STAGE(pseudo_mass, (once), (C_boundary, x_boundary), (Psi), boundary, pseudo_mass, (step, relaxation),                \
        "Psi_b = rho0 / sum_l W_bl")                                                                                    \
  STAGE(grid_count, (sort), (x_in), (cell, C), fluid, always, (step, relaxation),                                       \
        "C[c] = number of particles in cell c")                                                                         \
  STAGE(grid_scan, (sort), (C), (C), cells, always, (step, relaxation),                                                 \
        "C[c] := C[0] + ... + C[c]")                                                                                    \
  STAGE(grid_scatter, (sort), (cell, C), (C, L), fluid, always, (step, relaxation),                                     \
        "C[c] := C[c] - 1, L[C[c]] = i")                                                                                \
  STAGE(grid_order, (sort), (cell, C, L, id_in), (L), cells, always, (step, relaxation),                                \
        "L within each cell by id")                                                                                     \
  STAGE(reorder, (sort), (L, id_in, x_in, v_in), (id, x, v), fluid, always, (step, relaxation),                         \
        "x_i = x_in[L[i]], ...")                                                                                        \
  STAGE(neighbours, (search), (x, C), (list, index, list_needed), fluid, always, (step, relaxation),                    \
        "j: |x_ij| < 2H")                                                                                               \
  STAGE(boundary, (search), (x, C_boundary, x_boundary, Psi),                                                           \
        (wall_density, wall_gradient, wall_gradient_squares, wall_viscosity), fluid, boundary, (step, relaxation),      \
        "sum_b m_b W_ib, B_i = sum_b m_b dW_ib, ...")                                                                   \
  STAGE(density, (search), (id, x, list, index, wall_density), (rho, gradient), fluid, always, (step, relaxation),      \
        "rho_i = m (W_ii + sum_j W_ij) + sum_b m_b W_ib, and dW_ij")                                                    \
  STAGE(clamp_density, (search), (rho), (rho), fluid, tait, (step, relaxation),                                                     \
        "rho := max(rho, rho0)")                                                                                        \
  STAGE(external, (forces), (x), (a_n), fluid, always, (step, relaxation),                                              \
        "a_n = g - c (x - centre)")                                                                                     \
  STAGE(viscosity, (forces), (list, index, gradient, x, v, rho, wall_viscosity, a_n), (a_n), fluid, laplacian, (step, relaxation),  \
        "a_n += 2 nu sum (m/rho_j) (v_ij.x_ij)/(x_ij.x_ij + 0.01 H^2) dW_ij")                                           \
  STAGE(xsph, (forces), (list, index, x, v, rho, a_n), (a_n), fluid, xsph, (step, relaxation),                                      \
        "a_n -= (alpha/dt) m sum_j (v_ij/rho_j) W_ij")                                                                  \
  STAGE(predict, (forces), (v, a_n), (v_star), fluid, always, (step, relaxation),                                       \
        "v* = v + dt a_n")                                                                                              \
  STAGE(state_equation, (forces), (rho), (p, q), fluid, state_equation, (step, relaxation),                                         \
        "p = max(k (rho/rho0 - 1), 0)")                                                                                 \
  STAGE(tait, (forces), (rho), (p, q), fluid, tait, (step, relaxation),                                                             \
        "p = kappa rho0/gamma ((rho/rho0)^gamma - 1)")                                                                  \
  STAGE(diagonal, (forces), (list, gradient, wall_gradient, wall_gradient_squares), (A_ii), fluid, linear_system,       \
        (step, relaxation), "A_ii = -dt^2 (|m sum_j dW + B_i|^2 + sum |m dW|^2)")                                       \
  STAGE(source, (forces), (list, index, gradient, v_star, rho, wall_gradient), (s), fluid, linear_system,               \
        (step, relaxation), "s_i = w (rho0 - rho_i) - dt m sum v*_ij.dW_ij")                                            \
  STAGE(warm_start, (forces), (L, p_in, rho), (q), fluid, linear_system, (step, relaxation),                            \
        "q = warm_start p/rho^2, with p of the last step")                                                              \
  STAGE(pressure_acceleration, (sweep, finish), (list, index, gradient, q, rho, wall_gradient), (a_p), fluid, always,   \
        (step, relaxation), "a_p = -m sum_j (q_i + q_j) dW_ij - (q_i [+ p_i/rho0^2: mirror]) B_i")                      \
  STAGE(pressure_operator, (sweep), (list, index, gradient, a_p, wall_gradient), (Ap), fluid, linear_system,            \
        (step, relaxation), "Ap = dt^2 (m sum_j (a_p,i - a_p,j).dW_ij + a_p,i.B_i)")                                    \
  STAGE(residual, (sweep), (Ap, s, A_ii, q, q_before, Ap_before), (residual_sums), chunks, linear_system,               \
        (step, relaxation), "sums of |s - Ap|, (s - Ap)^2, ... per chunk")                                              \
  STAGE(stop_test, (sweep), (residual_sums, sweeps, solve), (solve, sweeps), one, linear_system, (step, relaxation),    \
        "e, whether the system is solved, and the step t")                                                              \
  STAGE(pressure_update, (sweep), (Ap, s, A_ii, q, q_best, solve), (q, q_best, q_before, Ap_before), fluid,             \
        linear_system, (step, relaxation), "q := max(q + t (s - Ap)/A_ii, 0)")                                          \
  STAGE(pressure, (finish), (q, rho), (p), fluid, linear_system, (step, relaxation),                                    \
        "p = q rho^2")                                                                                                  \
  STAGE(integrate, (finish), (x, v_star, a_p), (x_in, v_in), fluid, always, (step),                                     \
        "v = v* + dt a_p, x = x + dt v")                                                                                \
  STAGE(relax, (finish), (x, v, a_p), (x_in, v_in), fluid, always, (relaxation),                                        \
        "x := x + a_p, moved by at most 0.1 h")                                                                         \
  STAGE(diagnostics, (finish), (x_in, v_in, v, rho, q, wall_gradient), (diagnostic_sums), chunks, always, (step),       \
        "sums and largest values per chunk")                                                                            \
  STAGE(totals, (finish), (diagnostic_sums), (totals), totals, always, (step),                                          \
        "the same over all chunks")
// clang-format on

enum class Phase : uint8_t {
#define PHASE(name, ...) name,
  SLUICE_PHASES(PHASE)
#undef PHASE
      count
};
inline constexpr uint32_t phase_count = static_cast<uint32_t>(Phase::count);
using PhaseSet = SetOf<Phase>;

struct PhaseInfo {
  Phase phase;
  Runs runs;
  Need need;
  std::string_view title;
};
inline constexpr std::array<PhaseInfo, phase_count> phase_table = {{
#define PHASE(name, runs, need, title) {Phase::name, Runs::runs, &Needs::need, title},
    SLUICE_PHASES(PHASE)
#undef PHASE
}};

/// What stages are run for: a step of the simulation, or one relaxation of the positions of a start.
enum class Task : uint8_t { step, relaxation, count };
using TaskSet = SetOf<Task>;

enum class Stage : uint8_t {
#define STAGE(name, ...) name,
  SLUICE_STAGES(STAGE)
#undef STAGE
      count
};
inline constexpr uint32_t stage_count = static_cast<uint32_t>(Stage::count);

struct StageInfo {
  std::string_view name;
  PhaseSet phases;
  FieldSet reads, writes;
  Length range;
  Need need;
  TaskSet tasks;
  std::string_view equation;
};

const std::array<StageInfo, stage_count>& stage_table();
const StageInfo& info(Stage stage);

/// Whether the stage runs before the first step, and not in every step.
bool runs_once(Stage stage);

/// Fields that `stage` reads or writes, less those that a scene with these needs has not.
FieldSet reads_of(Stage stage, const Needs& needs);
FieldSet writes_of(Stage stage, const Needs& needs);

}  // namespace sluice
