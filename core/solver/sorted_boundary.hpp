// Boundary samples in the order in which stages find them.
#pragma once

#include <vector>

#include "core/model/params.hpp"
#include "sluice/scene.hpp"

namespace sluice {

/// Boundary samples sorted by grid cell.
struct SortedBoundary {
  std::vector<uint32_t> C;       ///< first sample of each cell, and their number at the end
  std::vector<Vec2> x;           ///< from the domain's lower left corner
  std::vector<uint32_t> sample;  ///< place among Samples::boundary
};

SortedBoundary sort_boundary(const std::vector<Vec2>& samples, const Params& params);

}  // namespace sluice
