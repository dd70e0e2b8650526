// Impacts: a block on the floor, a jet on thin walls, a fluid that is slower than its own sound.
#include "studies/hard_case.hpp"

namespace sluice::study {
namespace {

constexpr double impact_step = 0.04;

/// Of IISPH; a state equation takes a fifth of it.
double step_of(const Method& method) {
  return method.label.starts_with("IISPH") ? impact_step : impact_step / 5;
}

/// A block that hits the floor of a closed box with `moves` spacings per step of IISPH.
void add_drop(HardCases& cases, const Method& method, double moves, bool adapts) {
  SceneParts parts;
  parts.title = fmt::format("A block hits the floor at {:g} spacings per step", moves);
  parts.size = {65 * h, 80 * h};
  parts.fluid = block({22 * h, 8 * h}, 20, 20, {0, -moves * h / impact_step});
  parts.boundary = container(parts, 3, true);
  parts.method = method;
  parts.time = adapts ? adaptive(5) : fixed(step_of(method), 5);
  HardCase& hard =
      cases.add(fmt::format("drop_{:g}_percent{}", 100 * moves, adapts ? "_adaptive" : ""), parts);
  hard.quick = method.suffix == "iisph" && (moves == 0.5 || (moves == 1 && adapts));
  hard.expected.energy_gain = 0.01;
  // A spacing per step carries particles of IISPH into the floor, two carry some through it.
  const bool implicit = method.label.starts_with("IISPH");
  if (implicit && moves >= 1 && !adapts) allow_stop(hard.expected, blown_up);
  // Here the block comes with half the speed of its sound.
  if (!implicit && moves == 2) allow_stop(hard.expected, blown_up);
  if (!implicit) hard.expected.lost = 5;
}

/// A jet that hits a wall of so many layers with `moves` spacings per step of IISPH.
void add_jet(HardCases& cases, const Method& method, double moves, const char* model, uint32_t layers) {
  SceneParts parts;
  parts.title = fmt::format("A jet on a wall, {}, layers {}", model, layers);
  parts.size = {80 * h, 60 * h};
  parts.fluid = block({10 * h, 25 * h}, 60, 6, {moves * h / impact_step, 0});
  parts.boundary = container(parts, layers, true);
  parts.boundary_model = model;
  parts.method = method;
  parts.time = fixed(step_of(method), 10);
  HardCase& hard = cases.add(fmt::format("jet_{:g}_{}_{}", 100 * moves, model, layers), parts);
  hard.quick = method.suffix == "iisph" && layers == 1 && moves == 1;
  const bool thin = layers < 3 && parts.boundary_model == "mirror";
  hard.expected.warned = thin;
  hard.expected.energy_gain = 0.01;
  hard.expected.lost = 3;
  // What a fluid that can be compressed is pressed through.
  if (method.suffix == "ssph" && layers == 1) hard.expected.lost = 36;
  if (method.suffix == "ssph" && layers == 1 && thin && moves == 1) hard.expected.least_lost = 1;
}

/// sqrt(k) is the speed of sound; the water lands with up to sqrt(2 g 240) = 69.
void add_soft(HardCases& cases, double stiffness) {
  SceneParts parts = dam("A fluid too soft for its fall", ssph(stiffness));
  parts.time = fixed(0.02, 20);
  HardCase& hard = cases.add(fmt::format("soft_{:g}", stiffness), parts);
  hard.quick = stiffness < 100;
  hard.expected.warned = true;
  expect_stop(hard.expected, "are lost, more than 10 %");
}

}  // namespace

void add_impacts(HardCases& cases) {
  for (const double moves : {0.2, 0.5, 1.0, 2.0}) {
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(7e5)}) {
      add_drop(cases, method, moves, false);
      add_drop(cases, method, moves, true);
    }
  }
  for (const double moves : {0.3, 1.0}) {
    for (const char* model : {"mirror", "akinci"}) {
      for (const uint32_t layers : {1u, 2u, 3u}) {
        for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(7e5)})
          add_jet(cases, method, moves, model, layers);
      }
    }
  }
  add_soft(cases, 25);
  add_soft(cases, 100);
}

}  // namespace sluice::study
