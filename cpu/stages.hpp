// The CPU's stages: one function per row of the stage table, defined in cpu/<stage>.cpp for float and double.
// Where wide registers pay, cpu/simd/<stage>.cpp defines it again.
#pragma once

#include "cpu/loops.hpp"

namespace sluice::cpu::SLUICE_SET {

#define STAGE(name, ...) \
  template <class Real>  \
  void name(State<Real>& state);
SLUICE_STAGES(STAGE)
#undef STAGE

}  // namespace sluice::cpu::SLUICE_SET

/// Defines the two precisions of a stage at the end of its file.
#define SLUICE_INSTANTIATE_STAGE(name)                                            \
  template void sluice::cpu::SLUICE_SET::name<float>(sluice::cpu::State<float>&); \
  template void sluice::cpu::SLUICE_SET::name<double>(sluice::cpu::State<double>&);
