// A backend that is watched while its neighbour list grows.
#pragma once

#include <algorithm>

#include "core/agree/agree.hpp"

namespace sluice::test {

/// Counts how often the list grows, and remembers how long it has become by that.
class Growing final : public ForwardingBackend {
 public:
  explicit Growing(Backend& backend) : ForwardingBackend(backend) {}
  void resize_list(uint64_t entries) override {
    ++times;
    largest = std::max(largest, entries);
    ForwardingBackend::resize_list(entries);
  }
  int times = 0;
  uint64_t largest = 0;
};

}  // namespace sluice::test
