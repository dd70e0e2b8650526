// Every combination of models that shaders and plans are made for.
#pragma once

#include <vector>

#include "core/stages.hpp"

namespace sluice::test {

inline std::vector<Needs> all_needs() {
  std::vector<Needs> all;
  for (int combination = 0; combination < 27; ++combination) {
    const int boundary = combination % 3, viscosity = combination / 3 % 3, method = combination / 9;
    Needs needs;
    needs.boundary = boundary > 0;
    needs.pseudo_mass = boundary == 2;
    needs.laplacian = viscosity == 1;
    needs.xsph = viscosity == 2;
    needs.state_equation = method == 0;
    needs.tait = method == 1;
    needs.linear_system = method == 2;
    all.push_back(needs);
  }
  return all;
}

}  // namespace sluice::test
