// How much memory a scene needs, known before anything is allocated.
#pragma once

#include "core/model/plan.hpp"
#include "core/solver/backend.hpp"
#include "sluice/scene.hpp"

namespace sluice {

struct MemoryNeed {
  double bytes = 0;         ///< everything
  double per_particle = 0;  ///< what one fluid particle costs: its fields and its share of the neighbour list
  double fluid = 0, boundary = 0;  ///< upper bounds on the counts
};

MemoryNeed memory_need(const Scene& scene, Precision precision);

/// Bytes this process may still take: free memory of the machine, or of its control group if that is less.
double available_memory();

/// Throws InputError at particles.spacing when the scene, `times` over, needs more than `available` bytes, or
/// more particles or grid cells than 32-bit indices can count.
void require_memory(const Scene& scene, Precision precision, double available, double times = 1);

}  // namespace sluice
