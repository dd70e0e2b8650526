// THE table of stages: what one simulation step is made of. A stage is a row here, a function cpu/<stage>.cpp
// and its equation in docs/model.md. Order is not decided here but by the plan (core/plan.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "core/model/fields.hpp"

namespace sluice {

struct Scene;

/// What a scene asks of the model; decides which stages are planned.
struct Needs {
  bool boundary = false;
  bool pseudo_mass = false;     ///< of boundary samples: the boundary model is akinci
  bool laplacian = false;       ///< viscosity
  bool xsph = false;            ///< viscosity
  bool state_equation = false;  ///< SSPH
  bool tait = false;            ///< WCSPH
  bool linear_system = false;   ///< IISPH
  bool thesis_wall = false;     ///< of the pressure system: mirror samples, which it counts once
  bool barzilai_borwein = false;
  bool relaxation = false;
};

Needs needs_of(const Scene& scene);

/// A set of fields.
class FieldSet {
 public:
  constexpr FieldSet() = default;
  constexpr FieldSet(std::initializer_list<Field> fields) {
    for (const Field field : fields) bits_ |= uint64_t{1} << static_cast<uint32_t>(field);
  }
  constexpr bool has(Field field) const { return (bits_ >> static_cast<uint32_t>(field)) & 1u; }
  constexpr FieldSet operator|(FieldSet other) const { return FieldSet(bits_ | other.bits_); }

 private:
  constexpr explicit FieldSet(uint64_t bits) : bits_(bits) {}
  static_assert(field_count <= 64);
  uint64_t bits_ = 0;
};

// clang-format off
#define SLUICE_STAGES(STAGE) \
  STAGE(pseudo_mass)                                                                                           \
  STAGE(grid_count) STAGE(grid_scan) STAGE(grid_scatter) STAGE(grid_order) STAGE(reorder) STAGE(neighbours)    \
  STAGE(boundary) STAGE(density) STAGE(clamp_density)                                                          \
  STAGE(external) STAGE(viscosity) STAGE(xsph) STAGE(predict) STAGE(state_equation) STAGE(tait)                \
  STAGE(diagonal) STAGE(source) STAGE(warm_start)                                                              \
  STAGE(pressure_acceleration) STAGE(pressure_operator) STAGE(residual) STAGE(stop_test)                       \
  STAGE(pressure_update) STAGE(pressure) STAGE(integrate) STAGE(relax) STAGE(diagnostics) STAGE(totals)
// clang-format on

enum class Stage : uint8_t {
#define STAGE(name) name,
  SLUICE_STAGES(STAGE)
#undef STAGE
      count
};
inline constexpr uint32_t stage_count = static_cast<uint32_t>(Stage::count);

/// Stages before those of the grid run once, before the first step, and not in every step.
constexpr bool runs_once(Stage stage) { return stage < Stage::grid_count; }

struct StageInfo {
  std::string_view name;
  FieldSet reads, writes;
  Length range;  ///< what one invocation works on
  bool (*needed)(const Needs&);
  std::string_view equation;  ///< in short; docs/model.md has it with its source
};

const std::array<StageInfo, stage_count>& stage_table();
const StageInfo& info(Stage stage);

/// The fields `stage` reads, less those of models the scene does without.
FieldSet reads_of(Stage stage, const Needs& needs);
FieldSet writes_of(Stage stage, const Needs& needs);

}  // namespace sluice
