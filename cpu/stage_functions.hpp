// Which function runs a stage: the plain one, or with a set of instructions that of cpu/simd/, where there is
// one. The build says which sets there are, and which stages have a file there.
#pragma once

#include <array>

#include "cpu/backend.hpp"
#include "cpu/instructions.hpp"
#include "cpu/simd/part.hpp"
#include "simd_stages.hpp"

namespace sluice::cpu {

template <class Real>
struct StageFunctions {
  std::array<void (*)(State<Real>&), stage_count> all;  ///< in the order of Stage
  /// Stages run part by part; null where they cannot be.
  PartFunction<Real> pressure_acceleration = nullptr, pressure_operator = nullptr;
};

#define DECLARE(name, ...) \
  template <class Real>    \
  void name(State<Real>& state);
#define DECLARE_PART(name) \
  template <class Real>    \
  void name(State<Real>& state, Part part);
#define OVERRIDE(name) functions.all[static_cast<uint32_t>(Stage::name)] = name<Real>;
#define OVERRIDE_PART(name) functions.name = name<Real>;

namespace plain {
SLUICE_STAGES(DECLARE)
}

#define SET(set)                                      \
  namespace set {                                     \
  SLUICE_SIMD_STAGES(DECLARE)                         \
  SLUICE_PARTWISE_STAGES(DECLARE_PART)                \
  template <class Real>                               \
  void override_in(StageFunctions<Real>& functions) { \
    SLUICE_SIMD_STAGES(OVERRIDE)                      \
    SLUICE_PARTWISE_STAGES(OVERRIDE_PART)             \
  }                                                   \
  }
SLUICE_SIMD_SETS(SET)
#undef SET

/// The functions to take with `instructions`, which the build has to have.
template <class Real>
StageFunctions<Real> functions_with(Instructions instructions) {
#define PLAIN(name, ...) plain::name<Real>,
  StageFunctions<Real> functions{{SLUICE_STAGES(PLAIN)}};
#undef PLAIN
#define SET(set) \
  if (instructions == Instructions::set) set::override_in(functions);
  SLUICE_SIMD_SETS(SET)
#undef SET
  return functions;
}

#undef DECLARE
#undef DECLARE_PART
#undef OVERRIDE
#undef OVERRIDE_PART

}  // namespace sluice::cpu
