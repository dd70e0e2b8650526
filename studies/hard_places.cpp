// Places and numbers: walls out of line with the grid, scenes far away, strays, particles on the edges of
// cells, NaN.
#include "core/model/params.hpp"
#include "studies/hard_case.hpp"

namespace sluice::study {
namespace {

void add_lengths(HardCases& cases) {
  for (int eighths = 0; eighths < 8; ++eighths) {
    SceneParts parts = dam("Dam in a tank of another length", iisph(), 400 + eighths * h / 8);
    parts.time = fixed(0.04, 20);
    HardCase& hard = cases.add(fmt::format("dam_length_{}_eighths", eighths), parts);
    hard.quick = eighths == 3;
    hard.expected.energy_gain = 0.01;
  }
}

void add_distances(HardCases& cases) {
  for (const Method& method : {iisph(), ssph(7e5)}) {
    SceneParts here = dam("Dam", method);
    here.time = fixed(method.suffix == "ssph" ? 0.01 : 0.04, 10);
    for (const uint32_t away : {10000u, 1000000u}) {
      SceneParts there = dam("Dam far away", method, 400, Vec2(away, -1.0 * away) * h);
      there.time = here.time;
      HardCase& hard = cases.add(fmt::format("dam_moved_by_{}_h", away), there);
      hard.same_as = scene_text(here);
      hard.quick = method.suffix == "iisph" && away == 1000000;
    }
  }
}

/// One more particle stands 1e6 h below, beside or above the domain.
void add_strays(HardCases& cases) {
  struct Stray {
    const char* name;
    Vec2 place;
    uint32_t lost;
  };
  for (const auto& [name, place, lost] : {Stray{"below", {10, -1e6}, 1}, Stray{"left", {-1e6, 10}, 1},
                                          Stray{"right", {1e6, 10}, 1}, Stray{"above", {10, 1e6}, 0}}) {
    for (const Method& method : {iisph(), ssph(7e5)}) {
      SceneParts parts = dam("A particle astray", method);
      parts.fluid += block(h * place, 1, 1);
      parts.time = fixed(method.suffix == "ssph" ? 0.01 : 0.04, 10);
      HardCase& hard = cases.add(fmt::format("stray_{}", name), parts);
      hard.quick = method.suffix == "iisph" && place.y < 0;
      hard.expected.warned = method.suffix == "ssph" && place.y == 1e6;  // of the speed it may reach
      hard.expected.lost = lost;
      hard.expected.least_lost = lost;
      hard.expected.list_growths = 0;
      const Expectation expected = hard.expected;
      parts.time = adaptive(3);
      HardCase& adapting = cases.add(fmt::format("stray_{}_adaptive", name), parts);
      adapting.expected = expected;
    }
  }
}

/// A block whose particles stand on edges, corners and middles of the grid's cells.
void put_on_edges(const Scene& scene, Samples& samples) {
  const double edge = 1 / make_params(scene, static_cast<uint32_t>(samples.fluid.size())).inverse_cell;
  const Vec2 corner = samples.fluid.front() - scene.domain_min;
  for (Vec2& x : samples.fluid) {
    const Vec2 place = glm::round((x - scene.domain_min - corner) / scene.spacing);
    x = scene.domain_min + (glm::round(2.0 * corner / edge) + place) * (edge / 2);
  }
}

void add_cell_edges(HardCases& cases) {
  for (const Method& method : {iisph(), ssph(7e5)}) {
    SceneParts parts;
    parts.title = "Particles on the edges of cells";
    parts.size = {40 * h, 60 * h};
    parts.fluid = block({8 * h, 6 * h}, 20, 20);
    parts.boundary = container(parts);
    parts.method = method;
    parts.time = fixed(method.suffix == "ssph" ? 0.01 : 0.04, 10);
    HardCase& hard = cases.add("on_cell_edges", parts);
    hard.rearrange = put_on_edges;
    hard.expected.energy_gain = 0.01;
    hard.quick = method.suffix == "iisph";
  }
}

}  // namespace

void add_places(HardCases& cases) {
  add_lengths(cases);
  add_distances(cases);
  add_strays(cases);
  add_cell_edges(cases);
}

void add_numbers(HardCases& cases) {
  struct Number {
    const char *name, *text;
    Outcome outcome;
    const char* reason;
  };
  for (const auto& [name, text, outcome, reason] :
       {Number{"velocity_nan", "nan", Outcome::refused, "fluid.rect.0.velocity"},
        Number{"velocity_inf", "inf", Outcome::refused, "fluid.rect.0.velocity"},
        Number{"velocity_1e300", "1e300", Outcome::refused, "fluid.rect.0"},
        Number{"velocity_1e30", "1e30", Outcome::stopped, "a particle moved by"}}) {
    for (const Method& method : {iisph(), ssph(7e5), wcsph(7e5)}) {
      SceneParts parts = dam("A speed that is none", method);
      parts.fluid =
          fmt::format("[[fluid.rect]]\nmin = [24, 24]\ncount = [10, 10]\nvelocity = [0, {}]\n", text);
      parts.time = fixed(0.01, 1);
      HardCase& hard = cases.add(name, parts);
      hard.quick = true;
      hard.expected.outcome = outcome;
      hard.expected.reason = reason;
      hard.expected.warned = *text == '1' && method.suffix != "iisph";  // of sound
      hard.expected.stopped_by = outcome == Outcome::stopped ? 1 : 0;
    }
  }
}

}  // namespace sluice::study
