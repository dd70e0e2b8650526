// A counting sort.
#include "core/solver/sorted_boundary.hpp"

#include <numeric>

namespace sluice {

SortedBoundary sort_boundary(const std::vector<Vec2>& samples, const Params& params) {
  SortedBoundary sorted;
  sorted.C.assign(uint64_t{params.columns} * params.rows + 1, 0);
  sorted.x.resize(samples.size());
  sorted.sample.resize(samples.size());
  const auto cell = [&](Vec2 x) { return cell_of(params, x - params.origin); };
  for (const Vec2 x : samples) ++sorted.C[cell(x) + 1];
  std::partial_sum(sorted.C.begin(), sorted.C.end(), sorted.C.begin());
  std::vector<uint32_t> next = sorted.C;
  for (uint32_t b = 0; b < samples.size(); ++b) {
    const uint32_t place = next[cell(samples[b])]++;
    sorted.x[place] = samples[b] - params.origin;
    sorted.sample[place] = b;
  }
  return sorted;
}

}  // namespace sluice
