// The CPU's stages: one function per row of the stage table, defined in cpu/<stage>.cpp for float and double,
// and compiled for every set of instructions.
#pragma once

#include "core/model/stages.hpp"
#include "cpu/loops.hpp"

namespace sluice::cpu::SLUICE_SET {

#define STAGE(name, ...)     \
  template <class Real> \
  void name(State<Real>& state);
SLUICE_STAGES(STAGE)
#undef STAGE

/// Those that can also be run part by part, for the backend to run them side by side.
#define STAGE(name, ...)     \
  template <class Real> \
  void name(State<Real>& state, Range part);
SLUICE_PARTWISE_STAGES(STAGE)
#undef STAGE

}  // namespace sluice::cpu::SLUICE_SET

/// Defines the two precisions of a stage at the end of its file.
#define SLUICE_INSTANTIATE_STAGE(name)                                            \
  template void sluice::cpu::SLUICE_SET::name<float>(sluice::cpu::State<float>&); \
  template void sluice::cpu::SLUICE_SET::name<double>(sluice::cpu::State<double>&);

/// Defines them for a stage that is written for a part of the particles, and the stage for all of them.
#define SLUICE_INSTANTIATE_PARTWISE_STAGE(name)                   \
  namespace sluice::cpu::SLUICE_SET {                             \
  template <class Real>                                           \
  void name(State<Real>& state) {                                 \
    for_each_part(state, [&](Range part) { name(state, part); }); \
  }                                                               \
  template void name<float>(State<float>&, Range);                \
  template void name<double>(State<double>&, Range);              \
  }                                                               \
  SLUICE_INSTANTIATE_STAGE(name)
