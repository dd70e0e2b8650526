// Every combination of choices that plans and shaders are made for.
#pragma once

#include <type_traits>
#include <vector>

#include "core/model/needs.hpp"

namespace sluice::test {

/// All values of a choice, `none` among them where there is one, or false and true.
template <class Choice>
std::vector<Choice> all_of() {
  if constexpr (std::is_same_v<Choice, bool>) {
    return {false, true};
  } else {
    std::vector<Choice> values = values_of<Choice>();
    if (choices_of(Choice{}).first > 0) values.push_back(Choice{});
    return values;
  }
}

/// The models, each with every value of one more choice.
template <class Choice>
std::vector<Model> with_all(const std::vector<Model>& models, Choice Model::*choice) {
  std::vector<Model> all;
  for (Model model : models)
    for (const Choice value : all_of<Choice>()) model.*choice = value, all.push_back(model);
  return all;
}

inline std::vector<Model> all_models() {
  std::vector<Model> all{Model{}};
#define CHOICE(type, name, chosen, relaxing) all = with_all(all, &Model::name);
  SLUICE_MODEL(CHOICE)
#undef CHOICE
  return all;
}

}  // namespace sluice::test
