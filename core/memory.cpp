// Upper bounds from the shapes and the field table.
#include "core/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/params.hpp"
#include "core/sampling.hpp"
#include "core/text.hpp"

namespace sluice {
namespace {

/// Positions, velocities and ids on the host while a run starts or is written out.
constexpr double host_bytes_per_particle = 150;
constexpr double largest_count = 2147483647.0;

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
  const FieldSet fields = make_plan(needs_of(scene)).fields();
  const double list_per_particle = first_list_length * scene.smoothing * scene.smoothing;
  double per_particle = 0, per_cell = 0, per_sample = 0;
  for (uint32_t i = 0; i < field_count; ++i) {
    const FieldInfo& field = field_table[i];
    if (!fields.has(static_cast<Field>(i))) continue;
    const double bytes = element_bytes(field.type, real_bytes);
    if (field.length == Length::fluid) per_particle += bytes;
    if (field.length == Length::list) per_particle += bytes * list_per_particle;
    if (field.length == Length::gradients) per_particle += 2 * bytes * list_per_particle;
    if (field.length == Length::residual) per_particle += 2 * bytes / chunk_width;
    if (field.length == Length::diagnostics) per_particle += total_count * bytes / chunk_width;
    if (field.length == Length::cells) per_cell += bytes;
    if (field.length == Length::boundary) per_sample += bytes;
  }
  MemoryNeed need{0, per_particle, bounds.fluid, bounds.boundary};
  need.bytes = bounds.fluid * (per_particle + host_bytes_per_particle) +
               bounds.boundary * (per_sample + host_bytes_per_particle) + cells.x * cells.y * per_cell;
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

void require_memory(const Scene& scene, Precision precision, double available) {
  const MemoryNeed need = memory_need(scene, precision);
  const glm::dvec2 cells = grid_cells(scene);
  const double entries = need.fluid * first_list_length * scene.smoothing * scene.smoothing;
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
