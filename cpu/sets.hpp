// The stages' functions, once for each set of instructions they are compiled for.
#pragma once

#include <array>

#include "cpu/backend.hpp"
#include "cpu/state.hpp"

namespace sluice::cpu {

template <class Real>
struct StageFunctions {
  std::array<void (*)(State<Real>&), stage_count> all;  ///< in the order of Stage
  void (*pressure_acceleration)(State<Real>&, Range part);
  void (*pressure_operator)(State<Real>&, Range part);
};

#define STAGE_OF_SET(name, ...) \
  template <class Real>         \
  void name(State<Real>& state);
#define PART_OF_SET(name) \
  template <class Real>   \
  void name(State<Real>& state, Range part);
namespace baseline {
SLUICE_STAGES(STAGE_OF_SET)
SLUICE_PARTWISE_STAGES(PART_OF_SET)
}  // namespace baseline
namespace avx2 {
SLUICE_STAGES(STAGE_OF_SET)
SLUICE_PARTWISE_STAGES(PART_OF_SET)
}  // namespace avx2
namespace avx512 {
SLUICE_STAGES(STAGE_OF_SET)
SLUICE_PARTWISE_STAGES(PART_OF_SET)
}  // namespace avx512
#undef STAGE_OF_SET
#undef PART_OF_SET

template <class Real>
const StageFunctions<Real>& stages_for(Instructions instructions) {
#define BASELINE(name, ...) baseline::name<Real>,
#define AVX2(name, ...) avx2::name<Real>,
#define AVX512(name, ...) avx512::name<Real>,
  static constexpr StageFunctions<Real> functions[] = {
      {{SLUICE_STAGES(BASELINE)}, SLUICE_PARTWISE_STAGES(BASELINE)},
#ifdef SLUICE_WIDE_SETS
      {{SLUICE_STAGES(AVX2)}, SLUICE_PARTWISE_STAGES(AVX2)},
      {{SLUICE_STAGES(AVX512)}, SLUICE_PARTWISE_STAGES(AVX512)},
#endif
  };
#undef BASELINE
#undef AVX2
#undef AVX512
  return functions[static_cast<uint32_t>(instructions)];
}

}  // namespace sluice::cpu
