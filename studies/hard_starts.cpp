// Hard starts: very few particles; too many of them in too little room.
#include <cmath>

#include "studies/hard_case.hpp"

namespace sluice {
namespace {

SceneParts open_box(const std::string& title, const Method& method, const std::string& fluid) {
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
};

std::vector<Few> few_particles() {
  std::string apart;
  for (int i = 0; i < 5; ++i) apart += block({(5.0 + 6 * i) * h, (10.0 + 3 * i) * h}, 1, 1);
  return {{"one_particle", "One particle", block({20 * h, 20 * h}, 1, 1)},
          {"two_particles", "Two particles", block({20 * h, 20 * h}, 2, 1)},
          {"none_in_reach", "Five particles out of reach", apart},
          {"row_of_30", "A row of 30", block({5 * h, 20 * h}, 30, 1)},
          {"line_of_30", "A line of 30", block({20 * h, 10 * h}, 1, 30)}};
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
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(1e6), wcsph(1e6)}) {
      const bool implicit = method.label.starts_with("IISPH");
      SceneParts parts =
          open_box("Coincident pairs", method, block({5 * h, 3 * h}, 20, 20) + block({30 * h, 3 * h}, 2, 5));
      parts.time = fixed(implicit ? 0.02 : 0.005, 5);
      HardCase& hard = cases.add(fmt::format("pairs_at_{}", name), parts);
      hard.rearrange = [distance = distance](const Scene& scene, Samples& samples) {
        pair_up(scene, samples, distance);
      };
      hard.expected.closest = 0.3;
      hard.quick = distance == 0 && method.suffix != "thesis";
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
  parts.boundary = container(parts);
  parts.method = method;
  return parts;
}

void add_compressed(HardCases& cases) {
  for (const double compression : {0.05, 0.2, 0.5}) {
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(1.6e5), wcsph(1.6e5)}) {
      const bool implicit = method.label.starts_with("IISPH");
      SceneParts parts = compressed(method, compression);
      const std::string name = fmt::format("compressed_{:g}_percent", 100 * compression);
      parts.time = fixed(implicit ? 0.04 : 0.01, 10);
      cases.add(name, parts).quick = method.suffix == "iisph";
      parts.time = adaptive(10);
      cases.add(fmt::format("{}_adaptive", name), parts).quick = method.suffix == "iisph";
    }
  }
}

/// So many by so many particles that meet in one place within `steps` steps.
void add_crowd(HardCases& cases, uint32_t edge, int steps) {
  SceneParts parts;
  parts.title = fmt::format("{} particles driven into one cell", edge * edge);
  parts.size = Vec2(edge + 10.0) * h;
  parts.fluid = shrinking_block({5 * h, 5 * h}, edge, edge, 1);
  parts.gravity = 0;
  parts.nu = 0;
  parts.method = ssph(1e-6);
  parts.time = fixed(1.0 / steps, 2);
  HardCase& hard = cases.add(fmt::format("crowd_of_{}", edge * edge), parts);
  hard.quick = edge < 200;
  hard.expected.outcome = Outcome::stopped;
  hard.expected.reason = "crowd together";
  hard.expected.stopped_by = static_cast<uint64_t>(steps) + 1;
}

}  // namespace

void add_few_particles(HardCases& cases) {
  for (const auto& [name, title, fluid] : few_particles()) {
    for (const Method& method : {iisph(), iisph_of_the_thesis(), ssph(1e6), wcsph(1e6)}) {
      const bool implicit = method.label.starts_with("IISPH");
      SceneParts parts = open_box(title, method, fluid);
      parts.time = fixed(implicit ? 0.04 : 0.005, 20);
      cases.add(name, parts).quick = method.suffix == "iisph";
      parts.title = fmt::format("{}, falling freely", title);
      parts.boundary.clear();
      parts.time = fixed(0.04, 3);  // 44 of at least 80 to the domain's lower edge
      cases.add(fmt::format("{}_free", name), parts).quick = method.suffix == "iisph";
    }
  }
}

void add_crowded_starts(HardCases& cases) {
  add_coincident(cases);
  add_compressed(cases);
  add_crowd(cases, 141, 20);
  add_crowd(cases, 1000, 20);
  add_crowd(cases, 1000, 8);
}

}  // namespace sluice
