#include "tests/support/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace sluice::test {

std::vector<ShippedRun> shipped_runs() {
  std::vector<ShippedRun> runs;
  for (const std::string& name : shipped_scenes()) {
    const size_t before = runs.size();
    for (const PressureMethod method : values_of<PressureMethod>()) {
      try {
        runs.push_back({name, std::string(name_of(method))});
        runs.back().load();
      } catch (const InputError&) {  // this scene has no table for the method
        runs.pop_back();
      }
    }
    // The tests of a scene that can't be read will say why; here no test runs yet.
    if (runs.size() == before) runs.push_back({name, "iisph"});
  }
  return runs;
}
namespace {

template <class T, class Size>
double difference(const std::vector<T>& a, const std::vector<T>& b, Size size) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a.size() != b.size() || a.empty() || a.data() == b.data()) return infinity;
  double largest = 0, apart = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double here = size(a[i] - b[i]);
    if (!std::isfinite(here)) return infinity;
    apart = std::max(apart, here);
    largest = std::max(largest, size(b[i]));
  }
  // A reference that is zero everywhere compares nothing.
  return largest > 0 ? apart / largest : infinity;
}

}  // namespace

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  return difference(a, b, [](double value) { return std::abs(value); });
}

double relative_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return difference(a, b, [](Vec2 value) { return glm::length(value); });
}

}  // namespace sluice::test
