// Every combination of choices that plans and shaders are made for.
#pragma once

#include <vector>

#include "core/model/needs.hpp"

namespace sluice::test {

/// All values of a choice, `none` among them where there is one.
template <class Enum>
std::vector<Enum> all_of() {
  std::vector<Enum> values = values_of<Enum>();
  if (choices_of(Enum{}).first > 0) values.push_back(Enum{});
  return values;
}

inline std::vector<Model> all_models() {
  std::vector<Model> all;
  for (const auto boundary : all_of<BoundaryModel>())
    for (const auto viscosity : all_of<ViscosityModel>())
      for (const auto method : all_of<PressureMethod>())
        for (const auto wall : all_of<Wall>())
          for (const auto solver : all_of<Solver>())
            all.push_back({boundary, viscosity, method, wall, solver});
  return all;
}

}  // namespace sluice::test
