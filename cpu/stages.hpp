// The CPU's stages: one function per row of the stage table, defined in cpu/<stage>.cpp for float and double.
#pragma once

#include "core/stages.hpp"
#include "cpu/state.hpp"

namespace sluice::cpu {

#define STAGE(name)     \
  template <class Real> \
  void name(State<Real>& state);
SLUICE_STAGES(STAGE)
#undef STAGE

}  // namespace sluice::cpu

/// Defines the two precisions of a stage at the end of its file.
#define SLUICE_INSTANTIATE_STAGE(name)                                \
  template void sluice::cpu::name<float>(sluice::cpu::State<float>&); \
  template void sluice::cpu::name<double>(sluice::cpu::State<double>&);
