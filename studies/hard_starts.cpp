// Hard starts: very few particles; too many of them in too little room.
#include <algorithm>
#include <cmath>

#include "studies/hard_case.hpp"

namespace sluice::study {
namespace {

bool is_implicit(const Method& method) { return method.label.starts_with("IISPH"); }

SceneParts box(const std::string& title, const Method& method, const std::string& fluid) {
  SceneParts box;
  box.title = title;
  box.size = {40 * h, 60 * h};
  box.fluid = fluid;
  box.boundary = container(box);
  box.method = method;
  return box;
}

struct Few {
  const char* name;
  const char* title;
  std::string fluid;
  bool quick;
};

std::vector<Few> few_particles() {
  std::string apart;
  for (int i = 0; i < 5; ++i) apart += block({(5.0 + 6 * i) * h, (10.0 + 3 * i) * h}, 1, 1);
  return {{"one_particle", "One particle", block({20 * h, 20 * h}, 1, 1), true},
          {"two_particles", "Two particles", block({20 * h, 20 * h}, 2, 1), false},
          {"none_in_reach", "Five particles out of reach", apart, true},
          {"row_of_30", "A row of 30", block({5 * h, 20 * h}, 30, 1), false},
          {"line_of_30", "A line of 30", block({20 * h, 10 * h}, 1, 30), false}};
}

/// Moves the particles of the second shape, some of a block that stands aside, beside those of the first,
/// `distance` spacings from one each, in turning directions.
void pair_up(const Scene& scene, Samples& samples, double distance) {
  size_t first = 0;
  for (size_t i = 0; i < samples.fluid.size(); ++i) {
    if (samples.fluid_shape[i] == 0) continue;
    const double angle = static_cast<double>(i);
    samples.fluid[i] =
        samples.fluid[first] + distance * scene.spacing * Vec2(std::cos(angle), std::sin(angle));
    first += 37;  // of 400: every other row, another column each
  }
}

void add_coincident(HardCases& cases) {
  struct Distance {
    const char* name;
    double value;
  };
  for (const auto& [name, distance] :
       {Distance{"0", 0}, {"1e12th", 1e-12}, {"1e6th", 1e-6}, {"1e3rd", 1e-3}}) {
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(1.6e5), wcsph(1.6e5)}) {
      SceneParts parts =
          box("Coincident pairs", method, block({5 * h, 3 * h}, 20, 20) + block({30 * h, 3 * h}, 2, 5));
      parts.boundary = container(parts, 3, true);
      parts.time = fixed(is_implicit(method) ? 0.02 : 0.01, 10);
      HardCase& hard = cases.add(fmt::format("pairs_at_{}", name), parts);
      hard.rearrange = [distance = distance](const Scene& scene, Samples& samples) {
        pair_up(scene, samples, distance);
      };
      // Two particles in one place hold energy: pressure undoes a density of 1.46.
      hard.expected.energy_gain = 10;
      hard.expected.closest = 0.05;
      hard.quick = distance == 0 && method.suffix != "thesis" && method.suffix != "ssph";
    }
  }
}

/// 20 by 20 particles whose columns are closer by `compression`, between walls, at rest.
SceneParts compressed(const Method& method, double compression) {
  SceneParts parts;
  parts.title = fmt::format("A start compressed by {:g} %", 100 * compression);
  const double apart = h / (1 + compression);
  parts.size = {std::ceil(19 * apart / h + 6) * h, 60 * h};
  const double left = (parts.size.x - 19 * apart) / 2;
  for (int i = 0; i < 20; ++i) parts.fluid += block({left + i * apart, 3 * h}, 1, 20);
  parts.boundary = container(parts, 3, true);
  parts.method = method;
  return parts;
}

/// IISPH undoes a density in the next step, however short that is: the shorter, the faster particles fly
/// apart, and adaptive steps find none that is short enough. Undone in ten steps, it may be a fifth. A state
/// equation has no such trouble, unless Tait's makes the start stiffer than its time step.
void expect_of_compressed(Expectation& expected, double compression, const std::string& method, bool adapts) {
  const bool implicit = method.starts_with("IISPH"), slowly = method == gentle(iisph()).label;
  expected.energy_gain = compression == 0.05 ? 3 : compression == 0.2 ? 10 : 100;
  if (implicit && !slowly && compression > 0.1) {
    // Chance decides whether more than a tenth of the fluid passes the walls.
    const bool one_by_one = compression == 0.2 && !adapts;
    const bool at_once = compression == 0.5 && method == iisph_of_the_thesis().label;
    const char* reason = adapts && !at_once ? collapsed : blown_up;
    one_by_one ? allow_stop(expected, reason) : expect_stop(expected, reason);
  }
  // Here it takes steps of 0.403 spacings where 0.4 are allowed.
  if (method == iisph_of_the_thesis().label && compression == 0.05 && adapts) allow_stop(expected, collapsed);
  if (slowly && compression == 0.5 && adapts) expect_stop(expected, collapsed);
  if (method == "WCSPH" && compression == 0.5 && !adapts) expect_stop(expected, blown_up);
}

void add_compressed(HardCases& cases) {
  for (const double compression : {0.05, 0.2, 0.5}) {
    for (const Method& method :
         {iisph(), gentle(iisph()), iisph_of_the_thesis(), ssph(1.6e5), wcsph(1.6e5)}) {
      for (const bool adapts : {false, true}) {
        SceneParts parts = compressed(method, compression);
        parts.time = adapts ? adaptive(10) : fixed(is_implicit(method) ? 0.04 : 0.01, 10);
        HardCase& hard = cases.add(
            fmt::format("compressed_{:g}_percent{}", 100 * compression, adapts ? "_adaptive" : ""), parts);
        hard.quick = method.suffix == "iisph" && (adapts || compression == 0.5);
        expect_of_compressed(hard.expected, compression, method.label, adapts);
      }
    }
  }
}

/// `edge` by `edge` particles that meet in one place after `steps` steps.
void add_crowd(HardCases& cases, uint32_t edge, int steps) {
  SceneParts parts;
  parts.title = fmt::format("{} particles driven into one cell", edge * edge);
  parts.size = Vec2(edge + 10.0) * h;
  parts.fluid = shrinking_block({5 * h, 5 * h}, edge, edge, 1);
  parts.gravity = 0;
  parts.nu = 0;
  parts.method = ssph(1e-6);
  parts.time = fixed(1.0 / steps, 3);
  HardCase& hard = cases.add(fmt::format("crowd_of_{}_in_{}", edge * edge, steps), parts);
  hard.quick = edge < 200 && steps == 1;
  expect_stop(hard.expected, "crowd together");
  hard.expected.stopped_by = static_cast<uint64_t>(steps) + 1;
}

/// All of them in one place from the start.
void add_heap(HardCases& cases, uint32_t edge) {
  SceneParts parts;
  parts.title = fmt::format("{} particles in one place", edge * edge);
  parts.size = Vec2(edge + 10.0) * h;
  parts.fluid = block({5 * h, 5 * h}, edge, edge);
  parts.time = fixed(0.01, 1);
  HardCase& hard = cases.add(fmt::format("heap_of_{}", edge * edge), parts);
  hard.rearrange = [](const Scene&, Samples& samples) {
    std::fill(samples.fluid.begin(), samples.fluid.end(), Vec2(samples.fluid.front()));
  };
  hard.quick = edge < 200;
  hard.expected.outcome = Outcome::refused;
  hard.expected.reason = "fluid: found a start with too many particles in one place";
}

}  // namespace

void add_few_particles(HardCases& cases) {
  for (const auto& [name, title, fluid, quick] : few_particles()) {
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(1e6), wcsph(1e6)}) {
      SceneParts parts = box(title, method, fluid);
      const double dt = is_implicit(method) ? 0.04 : 0.005;
      parts.time = fixed(dt, 20);
      HardCase& landing = cases.add(name, parts);
      landing.quick = quick && method.suffix == "iisph";
      landing.expected.rise = 0;
      landing.expected.mean_compression = 0.005;
      parts.title = fmt::format("{}, falling freely", title);
      parts.boundary.clear();
      parts.time = fixed(dt, 3);  // 44 of at least 80 to the domain's lower edge
      HardCase& falling = cases.add(fmt::format("{}_free", name), parts);

      falling.expected.rise = 0;
      falling.expected.mean_compression = 1e-6;
    }
  }
}

void add_crowded_starts(HardCases& cases) {
  add_coincident(cases);
  add_compressed(cases);
  // In a single step, the outermost of 141 by 141 move by just less than 100 spacings.
  for (const int steps : {1, 4, 20}) add_crowd(cases, 141, steps);
  add_crowd(cases, 1000, 8);
  add_heap(cases, 141);
  add_heap(cases, 1000);
}

}  // namespace sluice::study
