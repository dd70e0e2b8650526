// Every combination of choices that plans and shaders are made for.
#pragma once

#include <vector>

#include "core/model/needs.hpp"

namespace sluice::test {

inline std::vector<Model> all_models() {
  std::vector<Model> all;
  for (const auto boundary : {BoundaryModel::none, BoundaryModel::mirror, BoundaryModel::akinci})
    for (const auto viscosity : {ViscosityModel::none, ViscosityModel::laplacian, ViscosityModel::xsph})
      for (const auto method : {PressureMethod::ssph, PressureMethod::wcsph, PressureMethod::iisph})
        for (const auto wall : {Wall::thesis, Wall::symmetric})
          for (const auto solver : {Solver::jacobi, Solver::barzilai_borwein})
            all.push_back({boundary, viscosity, method, wall, solver});
  return all;
}

}  // namespace sluice::test
