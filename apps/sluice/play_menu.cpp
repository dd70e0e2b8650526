// A grid of small pictures, one per scene.
#include "apps/sluice/play_menu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/scene_file.hpp"
#include "core/text.hpp"

namespace sluice {
namespace {

constexpr glm::uvec2 menu_size{960, 720};

/// A scene at its start.
struct Entry {
  Scene scene;
  Samples samples;
  std::string label;
  std::unique_ptr<gpu::Painter> painter;
};

/// Numbers 1 to 9; scenes beyond are chosen with the mouse.
std::vector<Entry> load_entries(const gpu::Context& context) {
  std::vector<Entry> entries;
  for (const std::string& name : shipped_scenes()) {
    Entry entry;
    entry.scene = load_scene(name);
    entry.samples = sample(entry.scene);
    const size_t number = entries.size() + 1;
    entry.label = number <= 9 ? fmt::format("{}  {}", number, name) : name;
    entries.push_back(std::move(entry));
  }
  for (Entry& entry : entries) {  // where they stay from now on
    entry.painter = std::make_unique<gpu::Painter>(context, entry.scene, entry.samples,
                                                   glm::uvec2(gpu::smallest_picture));
  }
  if (entries.empty())
    throw EnvironmentError("there are no shipped scenes beside this program; name a scene file to play");
  return entries;
}

/// Cells of equal size, as near to square as they get.
struct Grid {
  glm::uvec2 cells, cell;

  Grid(glm::uvec2 window, size_t count) {
    const double wanted = std::sqrt(static_cast<double>(count) * window.x / window.y);
    cells.x = std::clamp(static_cast<uint32_t>(std::lround(wanted)), 1u, static_cast<uint32_t>(count));
    cells.y = (static_cast<uint32_t>(count) + cells.x - 1) / cells.x;
    cell = glm::max(window / cells, gpu::smallest_picture);
  }

  glm::uvec2 corner(size_t k) const {
    return cell * glm::uvec2(static_cast<uint32_t>(k) % cells.x, static_cast<uint32_t>(k) / cells.x);
  }
  std::optional<size_t> at(glm::dvec2 place, size_t count) const {
    const glm::uvec2 here = glm::uvec2(glm::max(place, 0.0)) / cell;
    const size_t k = size_t{here.y} * cells.x + here.x;
    return here.x < cells.x && k < count ? std::optional(k) : std::nullopt;
  }
};

void show(Viewer& viewer, std::vector<Entry>& entries) {
  const glm::uvec2 window = viewer.size();
  const Grid grid(window, entries.size());
  for (size_t k = 0; k < entries.size(); ++k) {
    Entry& entry = entries[k];
    Frame labels;
    labels.text = {entry.label, fmt::format("{}, {} + {}", title_of(entry.scene.method),
                                            entry.samples.fluid.size(), entry.samples.boundary.size())};
    Snapshot state;
    state.x = entry.samples.fluid;
    state.v.resize(state.x.size());
    for (size_t i = 0; i < state.x.size(); ++i)
      state.v[i] =
          start_velocity(entry.scene.fluid[entry.samples.fluid_shape[i]], entry.scene.spacing, state.x[i]);
    entry.painter->renderer().look(grid.cell, {});
    entry.painter->paint(std::move(labels), entry.scene.dt, state);
    entry.painter->renderer().show(grid.corner(k), window.y);
  }
  viewer.present();
}

}  // namespace

std::optional<std::string> choose_scene(Viewer& viewer) {
  std::vector<Entry> entries = load_entries(viewer.context());
  viewer.begin(menu_size, Colour::speed, {});
  viewer.set_title("Sluice – choose a scene by its number or with the mouse");
  while (!viewer.over()) {
    if (viewer.changed()) show(viewer, entries);
    for (const WindowEvent& event : viewer.turn(true)) {
      std::optional<size_t> chosen;
      if (event.kind == WindowEvent::character && event.typed >= '1' && event.typed <= '9')
        chosen = event.typed - '1';
      if (event.kind == WindowEvent::press)
        chosen = Grid(viewer.size(), entries.size()).at(event.at, entries.size());
      if (chosen && *chosen < entries.size()) return entries[*chosen].scene.name;
    }
  }
  return std::nullopt;
}

}  // namespace sluice
