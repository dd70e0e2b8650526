// Every combination of models that shaders and plans are made for.
#pragma once

#include <vector>

#include "core/stages.hpp"

namespace sluice::test {

inline std::vector<Needs> all_needs() {
  std::vector<Needs> all;
  for (int bits = 0; bits < 8; ++bits) {
    Needs needs;
    needs.boundary = bits & 1;
    needs.laplacian = bits & 2;
    needs.linear_system = bits & 4;
    needs.state_equation = !needs.linear_system;
    all.push_back(needs);
  }
  return all;
}

}  // namespace sluice::test
