// Water that hangs together, and splashes that don't.
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "studies/validation_waters.hpp"

namespace sluice::study {
namespace {

/// Sets that are merged; each is named after one of its members.
class Sets {
 public:
  explicit Sets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), size_t{0}); }

  size_t of(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void merge(size_t i, size_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<size_t> parent_;
};

struct Cell {
  int64_t x, y;
  bool operator==(const Cell&) const = default;
};
struct CellHash {
  size_t operator()(const Cell& cell) const { return std::hash<int64_t>()(cell.x * 1000003 + cell.y); }
};

}  // namespace

std::vector<Vec2> connected_bulk(const std::vector<Vec2>& x, double reach) {
  std::unordered_map<Cell, std::vector<size_t>, CellHash> cells;
  Sets sets(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const Cell own{static_cast<int64_t>(std::floor(x[i].x / reach)),
                   static_cast<int64_t>(std::floor(x[i].y / reach))};
    for (int64_t dy = -1; dy <= 1; ++dy) {
      for (int64_t dx = -1; dx <= 1; ++dx) {
        const auto cell = cells.find({own.x + dx, own.y + dy});
        if (cell == cells.end()) continue;
        for (const size_t j : cell->second)
          if (distance(x[i], x[j]) <= reach) sets.merge(i, j);
      }
    }
    cells[own].push_back(i);
  }
  std::vector<size_t> sizes(x.size(), 0);
  size_t largest = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const size_t set = sets.of(i);
    if (++sizes[set] > sizes[largest]) largest = set;
  }
  std::vector<Vec2> bulk;
  for (size_t i = 0; i < x.size(); ++i)
    if (sets.of(i) == largest) bulk.push_back(x[i]);
  return bulk;
}

}  // namespace sluice::study
