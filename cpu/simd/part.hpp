// Stages that are run part by part: the two of a pressure sweep that walk over the neighbour list.
#pragma once

#include "cpu/state.hpp"

#define SLUICE_PARTWISE_STAGES(STAGE) STAGE(pressure_acceleration) STAGE(pressure_operator)

namespace sluice::cpu {

/// Particles that begin with a slice of the neighbour list.
struct Part : Range {
  size_t ahead = 0;  ///< so many particles further on another stage goes over the neighbour list next
};

template <class Real>
using PartFunction = void (*)(State<Real>&, Part part);

}  // namespace sluice::cpu
