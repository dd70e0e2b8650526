// Every array of a run, declared once with its type, length and unit. "In" fields hold the state a step
// starts from, in the order the last step left it; all others are in the cell order of the current step.
// Positions count from the domain's lower left corner, so that their digits do not depend on where the scene
// lies.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/model/needs.hpp"

namespace sluice {

/// Particles per slice of the neighbour list, and per partial sum of a reduction.
inline constexpr uint32_t slice_width = 16;
inline constexpr uint32_t chunk_width = 64;

/// What list_needed says when no list would do: its size has no 32-bit number, or more than most_rounds
/// candidates crowd around a particle.
inline constexpr uint32_t list_beyond_bounds = 0xffffffff;

/// What a field's length follows.
enum class Length { one, fluid, chunks, cells, boundary, list, gradients, residual, diagnostics, totals };

enum class Type { real, vec2, vec4, uint, uvec2 };

/// Candidates that a particle's neighbours are looked for among, at most: as many rounds as the loops of one
/// shader invocation may make, since some drivers end them all, silently, after 65535.
inline constexpr uint32_t most_rounds = 65'000;

/// Where the pressure solve of a step stands. Capped: it ended without having converged.
enum class Solve : uint32_t { unfinished, converged, capped };

// clang-format off
/// What a sweep of the pressure solve sums up over the particles, with r = s - Ap, and with S and Y the last
/// changes of q and of -r/A_ii; in this order. The last three are those of the Barzilai-Borwein step.
#define SLUICE_RESIDUAL_SUMS(SUM) \
  SUM(error) SUM(counted) SUM(squares) SUM(source_squares) SUM(SS) SUM(SY) SUM(YY)

/// What the totals of a step hold, in this order.
#define SLUICE_TOTALS(TOTAL) \
  TOTAL(density) TOTAL(compression) TOTAL(speed_squared) TOTAL(x) TOTAL(y) TOTAL(wall_force_x) TOTAL(wall_force_y) \
  TOTAL(lost) TOTAL(max_compression) TOTAL(max_speed_squared) TOTAL(max_speed_change_squared)
// clang-format on

enum class ResidualSum {
#define SUM(name) name,
  SLUICE_RESIDUAL_SUMS(SUM)
#undef SUM
      count
};
inline constexpr uint32_t residual_sum_count = static_cast<uint32_t>(ResidualSum::count);
inline constexpr std::array<std::string_view, residual_sum_count> residual_sum_names = {
#define SUM(name) #name,
    SLUICE_RESIDUAL_SUMS(SUM)
#undef SUM
};

enum class Total {
#define TOTAL(name) name,
  SLUICE_TOTALS(TOTAL)
#undef TOTAL
      count
};
inline constexpr uint32_t total_count = static_cast<uint32_t>(Total::count);
inline constexpr std::array<std::string_view, total_count> total_names = {
#define TOTAL(name) #name,
    SLUICE_TOTALS(TOTAL)
#undef TOTAL
};
/// The totals from this one on are folded by max, those before by sum.
inline constexpr uint32_t first_max_total = static_cast<uint32_t>(Total::max_compression);

// clang-format off
/// FIELD(name, type, length, need, unit, meaning). `need` says which scenes have the field.
#define SLUICE_FIELDS(FIELD) \
  FIELD(id_in, uint, fluid, always, "1", "id of each particle at the start of the step")                             \
  FIELD(x_in, vec2, fluid, always, "length", "position; integration writes it for the next step")                    \
  FIELD(v_in, vec2, fluid, always, "length/time", "velocity; integration writes it for the next step")               \
  FIELD(p_in, real, fluid, always, "density velocity^2", "pressure of the last step, in its order")                  \
  FIELD(rho_in, real, fluid, always, "density", "density of the last step, in its order")                            \
  FIELD(cell, uint, fluid, always, "1", "grid cell of each particle of the in fields")                               \
  FIELD(C, uint, cells, always, "1", "first place of each cell in L, and n at the end")                              \
  FIELD(L, uint, fluid, always, "1", "index into the in fields, by cell and then by id")                             \
  FIELD(id, uint, fluid, always, "1", "id")                                                                          \
  FIELD(x, vec2, fluid, always, "length", "position at the start of the step")                                       \
  FIELD(v, vec2, fluid, always, "length/time", "velocity at the start of the step")                                  \
  FIELD(p, real, fluid, always, "density velocity^2", "pressure")                                                    \
  FIELD(rho, real, fluid, always, "density", "density")                                                              \
  FIELD(list, uvec2, fluid, always, "1", "first entry and number of entries of the particle's neighbour list")       \
  FIELD(index, uint, list, always, "1", "neighbour j of each entry")                                                 \
  FIELD(gradient, real, gradients, always, "1/length^3", "kernel gradient of each entry: a slice's x "               \
        "components, then its y")                                                                                    \
  FIELD(list_needed, uint, one, always, "1", "entries the neighbour list needs; more than there are: it is not "     \
        "complete")                                                                                                  \
  FIELD(C_boundary, uint, cells, boundary, "1", "first boundary sample of each cell, and their number at the end")   \
  FIELD(x_boundary, vec2, boundary, boundary, "length", "position of each boundary sample, sorted by cell")          \
  FIELD(Psi, real, boundary, pseudo_mass, "mass", "pseudo-mass of each boundary sample")                             \
  FIELD(wall_density, real, fluid, boundary, "density", "sum_b m_b W_ib, with m_b the mass of a sample: m or Psi_b") \
  FIELD(wall_gradient, vec2, fluid, boundary, "density/length", "B_i = sum_b m_b dW_ib")                             \
  FIELD(wall_gradient_squares, real, fluid, thesis_wall, "density^2/length^2", "sum_b |m dW_ib|^2")                  \
  FIELD(wall_viscosity, vec4, fluid, wall_viscosity, "density/length^2", "sum_b m_b dW_ib x_ib^T / (x_ib.x_ib + "    \
        "0.01 H^2), by rows")                                                                                        \
  FIELD(a_n, vec2, fluid, always, "length/time^2", "non-pressure acceleration")                                      \
  FIELD(v_star, vec2, fluid, always, "length/time", "velocity without pressure, v*")                                 \
  FIELD(A_ii, real, fluid, linear_system, "density^2/velocity^2", "diagonal of the pressure system in q")            \
  FIELD(s, real, fluid, linear_system, "density", "source of the pressure system")                                   \
  FIELD(q, real, fluid, always, "velocity^2/density", "p / rho^2")                                                   \
  FIELD(a_p, vec2, fluid, always, "length/time^2", "pressure acceleration")                                          \
  FIELD(Ap, real, fluid, linear_system, "density", "operator applied to p")                                          \
  FIELD(q_best, real, fluid, linear_system, "velocity^2/density", "the q of this solve whose error e is the "        \
        "smallest so far")                                                                                           \
  FIELD(q_before, real, fluid, barzilai_borwein, "velocity^2/density", "q before the last update")                   \
  FIELD(Ap_before, real, fluid, barzilai_borwein, "density", "operator applied to that")                             \
  FIELD(residual_sums, real, residual, linear_system, "mixed", "per chunk: the entries of ResidualSum")              \
  FIELD(solve, vec4, one, linear_system, "mixed", "e of the sweep; the smallest e so far; step t of the update; "    \
        "what it starts from: 1 the last q, 0 nothing, -1 the best q, which it leaves as it is")                     \
  FIELD(sweeps, uvec2, one, linear_system, "1", "sweeps of this solve, and what has become of it: a Solve")          \
  FIELD(diagnostic_sums, real, diagnostics, always, "mixed", "per chunk: the entries of Total")                      \
  FIELD(totals, real, totals, always, "mixed", "the entries of Total over all chunks")
// clang-format on

enum class Field : uint8_t {
#define FIELD(name, type, length, need, unit, meaning) name,
  SLUICE_FIELDS(FIELD)
#undef FIELD
      count
};
inline constexpr uint32_t field_count = static_cast<uint32_t>(Field::count);

struct FieldInfo {
  std::string_view name;
  Type type;
  Length length;
  Need need;  ///< of the scenes that have it
  std::string_view unit, meaning;
};

inline constexpr std::array<FieldInfo, field_count> field_table = {{
#define FIELD(name, type, length, need, unit, meaning) \
  {#name, Type::type, Length::length, &Needs::need, unit, meaning},
    SLUICE_FIELDS(FIELD)
#undef FIELD
}};

constexpr const FieldInfo& info(Field field) { return field_table[static_cast<uint32_t>(field)]; }

/// Whether the field's elements are made of integers, and not of reals.
constexpr bool is_integer(Field field) {
  return info(field).type == Type::uint || info(field).type == Type::uvec2;
}

/// Numbers that an element is made of.
constexpr uint32_t components(Type type) {
  switch (type) {
    case Type::real:
    case Type::uint: return 1;
    case Type::vec2:
    case Type::uvec2: return 2;
    case Type::vec4: return 4;
  }
  return 0;
}

/// Bytes of one element with reals of `real_bytes` bytes.
constexpr uint32_t element_bytes(Type type, uint32_t real_bytes) {
  return components(type) * (type == Type::uint || type == Type::uvec2 ? 4 : real_bytes);
}

/// The numbers every length follows from.
struct Sizes {
  uint64_t fluid = 0, boundary = 0, cells = 0, list = 0;

  uint64_t chunks() const { return (fluid + chunk_width - 1) / chunk_width; }

  uint64_t of(Length length) const {
    switch (length) {
      case Length::one: return 1;
      case Length::fluid: return fluid;
      case Length::chunks: return chunks();
      case Length::cells: return cells + 1;
      case Length::boundary: return boundary;
      case Length::list: return list;
      case Length::gradients: return 2 * list;
      case Length::residual: return residual_sum_count * chunks();
      case Length::diagnostics: return total_count * chunks();
      case Length::totals: return total_count;
    }
    return 0;
  }
};

/// The list may grow to so many times its first size: beyond that the fluid has collapsed, and its memory
/// would no longer follow from the number of particles.
inline constexpr uint64_t most_list_growth = 8;

/// Neighbour list entries per particle to begin with, at H = h.
inline constexpr double first_list_length = 20;

/// Entries to set aside for the neighbour lists of `n` particles at smoothing H/h: the mean number of
/// neighbours is pi (2H/h)^2 - 1, a slice is as long as its longest list, and what is missing is added when
/// it is needed.
constexpr uint64_t first_list_size(uint64_t n, double smoothing) {
  const uint64_t slices = (n + slice_width - 1) / slice_width;
  const auto per_particle = static_cast<uint64_t>(first_list_length * smoothing * smoothing) + 1;
  return uint64_t{slice_width} * (slices * per_particle + 64);
}

}  // namespace sluice
