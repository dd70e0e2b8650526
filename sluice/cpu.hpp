// Simulations on the processor.
#pragma once

#include "sluice/choices.hpp"
#include "sluice/simulation.hpp"

namespace sluice::cpu {

struct DeviceOptions {
  Precision precision = Precision::single_;
  int threads = 0;  ///< 0 for as many as the machine runs at once; results do not depend on it
};

/// The processor. InputError when `threads` is below 0.
Device device(const DeviceOptions& options = {});

}  // namespace sluice::cpu
