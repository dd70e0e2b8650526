// Upper bounds from the shapes and the field table.
#include "core/solver/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include "core/model/params.hpp"
#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/sampling.hpp"

namespace sluice {
namespace {

/// Positions, velocities and ids on the host while a run starts or is written out.
constexpr double host_bytes_per_particle = 150;
constexpr double largest_count = 2147483647.0;

/// A count that may be beyond any integer, as one that is at least beyond any memory.
uint64_t capped(double count) { return static_cast<uint64_t>(std::min(std::ceil(count), 0x1p45)); }

/// A number in a file that holds only that, or infinity ("max", no such file).
double number_in(const char* path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : std::numeric_limits<double>::infinity();
}

}  // namespace

MemoryNeed memory_need(const Scene& scene, Precision precision) {
  const uint32_t real_bytes = precision == Precision::double_ ? 8 : 4;
  const SampleBounds bounds = sample_bounds(scene);
  const glm::dvec2 cells = grid_cells(scene);
  const auto bytes_of = [&](const Plan& plan, const Sizes& sizes) {
    double bytes = 0;
    for (uint32_t i = 0; i < field_count; ++i) {
      const FieldInfo& field = field_table[i];
      if (!plan.fields().has(static_cast<Field>(i))) continue;
      bytes += double(element_bytes(field.type, real_bytes)) * double(sizes.of(field.length));
    }
    return bytes;
  };
  const uint64_t fluid = capped(bounds.fluid);
  const Sizes sizes{fluid, capped(bounds.boundary), capped(cells.x * cells.y),
                    first_list_size(fluid, scene.smoothing)};
  const Model model = model_of(scene);
  const Plan plan = make_plan(model);
  MemoryNeed need;
  need.fluid = bounds.fluid;
  need.boundary = bounds.boundary;
  need.bytes = bytes_of(plan, sizes);
  if (scene.relax > 0) need.bytes = std::max(need.bytes, bytes_of(make_plan(model, Task::relaxation), sizes));
  need.bytes += (bounds.fluid + bounds.boundary) * host_bytes_per_particle;
  constexpr uint64_t many = 1'000'000;
  need.per_particle = bytes_of(plan, {many, 0, 0, first_list_size(many, scene.smoothing)}) / double(many);
  return need;
}

double available_memory() {
  double available = std::numeric_limits<double>::infinity();
  std::ifstream file("/proc/meminfo");
  for (std::string key; file >> key;) {
    double kilobytes = 0;
    if (key == "MemAvailable:" && file >> kilobytes) available = 1024 * kilobytes;
  }
  const double limit = number_in("/sys/fs/cgroup/memory.max"),
               used = number_in("/sys/fs/cgroup/memory.current");
  return limit < std::numeric_limits<double>::infinity() ? std::min(available, limit - used) : available;
}

void require_memory(const Scene& scene, Precision precision, double available, double times) {
  MemoryNeed need = memory_need(scene, precision);
  need.bytes *= times;
  const glm::dvec2 cells = grid_cells(scene);
  const auto entries = double(first_list_size(capped(need.fluid), scene.smoothing));
  const bool countable = need.fluid + need.boundary <= largest_count && cells.x * cells.y <= largest_count &&
                         entries <= 2 * largest_count;
  if (countable && need.bytes <= available) return;
  throw InputError(fmt::format(
      "{}: particles.spacing: found {:g}, which makes about {:.3g} particles, {:.3g} boundary samples and "
      "{:.3g} grid "
      "cells that need {}, expected a scene that fits into {}; use a larger spacing or a smaller scene",
      scene.spacing_where, scene.spacing, need.fluid, need.boundary, cells.x * cells.y,
      bytes_text(need.bytes),
      need.bytes <= available ? "32-bit counts"
                              : "the " + bytes_text(available) + " of memory that are free"));
}

}  // namespace sluice
