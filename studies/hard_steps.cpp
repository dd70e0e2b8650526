// Time steps: up to ten times what the speed of the water allows, viscosity beyond its limit, and steps that
// adapt.
#include "studies/hard_case.hpp"

namespace sluice::study {
namespace {

/// The time step with which a particle of breaking_dam moves about a spacing per step at its fastest.
constexpr double cfl_limit = 0.075;

/// Up to the limit nothing is lost. At twice of it the recommended settings hold, and with the thesis's wall
/// chance decides; from four times on, particles pass a wall of three layers in a step.
void expect_beyond_cfl(HardCase& hard, double times) {
  Expectation& expected = hard.expected;
  expected.warned = times > 1;  // of dt sqrt(g depth) / h
  if (times <= 1) expected.energy_gain = 0.01;
  if (times == 2) expected.lost = 5;
  if (times == 2 && hard.method != iisph().label) allow_stop(expected, blown_up);
  if (times > 2) expect_stop(expected, blown_up);
}

void add_cfl(HardCases& cases) {
  for (const double times : {0.5, 1.0, 2.0, 4.0, 10.0}) {
    for (const Method& method : {iisph(), iisph_of_the_thesis()}) {
      SceneParts parts = dam(fmt::format("Dam at {:g} times the CFL limit", times), method);
      parts.time = fixed(times * cfl_limit, 20);
      HardCase& hard = cases.add(fmt::format("dam_{:g}_percent_of_cfl", 100 * times), parts);
      hard.quick = times >= 2 && method.suffix == "iisph";
      expect_beyond_cfl(hard, times);
    }
  }
}

void add_adaptive(HardCases& cases) {
  for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(7e5), wcsph(7e5)}) {
    SceneParts parts = dam("Dam with adaptive steps", method);
    parts.time = adaptive(20);
    HardCase& hard = cases.add("dam_adaptive", parts);
    hard.quick = method.suffix == "iisph";
    hard.expected.energy_gain = 0.01;
  }
}

void add_viscosity(HardCases& cases) {
  const double dt = 0.04;
  for (const double share : {0.0, 0.5, 1.0, 4.0}) {
    SceneParts parts = dam(fmt::format("Dam with nu dt / h^2 = {:g}", share), iisph());
    parts.nu = share * h * h / dt;
    parts.time = fixed(dt, 20);
    HardCase& hard = cases.add(fmt::format("dam_viscosity_{:g}_percent", 100 * share), parts);
    hard.quick = share > 0.5;
    hard.expected.warned = share > 0.5;
    hard.expected.lost = share == 0 ? 5 : 0;  // lively water throws a drop or two over the rim
    hard.expected.energy_gain = 0.01;
    if (share > 0.5) expect_stop(hard.expected, blown_up);
    parts.time = adaptive(10);
    HardCase& adapting = cases.add(fmt::format("dam_viscosity_{:g}_percent_adaptive", 100 * share), parts);
    adapting.expected.lost = share == 0 ? 5 : 0;
    adapting.expected.energy_gain = 0.05;
  }
}

/// A block thrown at a wall, whose steps may not become short enough.
void add_collapse(HardCases& cases) {
  for (const Method& method : {iisph(), ssph(1e6)}) {
    SceneParts parts;
    parts.title = "A smallest step that is too long";
    parts.size = {60 * h, 40 * h};
    parts.fluid = block({10 * h, 3 * h}, 10, 10, {200, 0});
    parts.boundary = container(parts, 3, true);
    parts.method = method;
    parts.time = adaptive(5, 0.1, 0.05);
    HardCase& hard = cases.add("dt_min_too_long", parts);
    hard.quick = true;
    hard.expected.warned = method.suffix == "ssph";  // of sound
    expect_stop(hard.expected, "the time step collapsed: even with dt 0.05 a particle moved by");
  }
}

}  // namespace

void add_time_steps(HardCases& cases) {
  add_cfl(cases);
  add_adaptive(cases);
  add_viscosity(cases);
  add_collapse(cases);
}

}  // namespace sluice::study
