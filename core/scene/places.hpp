// Finds points closer to each other than half a spacing.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sluice/scene.hpp"

namespace sluice {

/// Points by cells of half a spacing; the points lie within 2^40 spacings of the origin.
class Places {
 public:
  explicit Places(double h) : edge_(h / 2), reach_(h / 2 * (1 - 1e-6)) {}

  void add(Vec2 point, uint32_t tag) {
    const uint32_t here = static_cast<uint32_t>(entries_.size());
    const auto [cell, fresh] = heads_.try_emplace(key(cell_of(point)), here);
    entries_.push_back({point, tag, fresh ? none : cell->second});
    cell->second = here;
  }

  struct Entry {
    Vec2 point;
    uint32_t tag, next;
  };

  /// An entry within h/2 of `point`, or nullptr.
  const Entry* near(Vec2 point) const {
    if (entries_.empty()) return nullptr;
    const glm::i64vec2 centre = cell_of(point);
    for (int64_t j = centre.y - 1; j <= centre.y + 1; ++j) {
      for (int64_t i = centre.x - 1; i <= centre.x + 1; ++i) {
        const auto cell = heads_.find(key({i, j}));
        for (uint32_t e = cell == heads_.end() ? none : cell->second; e != none; e = entries_[e].next) {
          if (glm::length(entries_[e].point - point) < reach_) return &entries_[e];
        }
      }
    }
    return nullptr;
  }

 private:
  static constexpr uint32_t none = ~0u;
  glm::i64vec2 cell_of(Vec2 point) const { return glm::i64vec2(glm::floor(point / edge_)); }
  static uint64_t key(glm::i64vec2 cell) {
    return static_cast<uint64_t>(cell.x) * 0x9e3779b97f4a7c15u ^ static_cast<uint64_t>(cell.y);
  }

  double edge_, reach_;
  std::unordered_map<uint64_t, uint32_t> heads_;
  std::vector<Entry> entries_;
};

}  // namespace sluice
