// How a stage that is run part by part is defined: for a part, and for all particles.
#pragma once

#include "cpu/simd/instructions.hpp"
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

#define STAGE(name)     \
  template <class Real> \
  void name(State<Real>& state, Part part);
SLUICE_PARTWISE_STAGES(STAGE)
#undef STAGE

}  // namespace sluice::cpu::SLUICE_SET

/// Defines the two precisions of a stage that is written for a part, and the stage for all particles.
#define SLUICE_INSTANTIATE_PARTWISE_STAGE(name)                            \
  namespace sluice::cpu::SLUICE_SET {                                      \
  template <class Real>                                                    \
  void name(State<Real>& state) {                                          \
    for_each_part(state, [&](Range part) { name(state, Part{part, 0}); }); \
  }                                                                        \
  template void name<float>(State<float>&, Part);                          \
  template void name<double>(State<double>&, Part);                        \
  }                                                                        \
  SLUICE_INSTANTIATE_STAGE(name)
