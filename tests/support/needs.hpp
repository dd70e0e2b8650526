// Every combination of models that shaders and plans are made for.
#pragma once

#include <vector>

#include "core/model/stages.hpp"

namespace sluice::test {

inline std::vector<Needs> all_needs() {
  std::vector<Needs> all;
  for (int combination = 0; combination < 72; ++combination) {
    const int boundary = combination % 4, viscosity = combination / 4 % 3, method = combination / 12 % 3;
    Needs needs;
    needs.boundary = boundary > 0;
    needs.pseudo_mass = boundary == 2;
    needs.thesis_wall = boundary == 3;
    needs.laplacian = viscosity == 1;
    needs.xsph = viscosity == 2;
    needs.state_equation = method == 0;
    needs.tait = method == 1;
    needs.linear_system = method == 2;
    needs.barzilai_borwein = combination / 36 == 1;
    all.push_back(needs);
  }
  return all;
}

}  // namespace sluice::test
