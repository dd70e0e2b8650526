// A grid of small pictures, one per scene.
#include "apps/sluice/play/menu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"

namespace sluice::app {
namespace {

/// A scene at its start.
struct Entry {
  Scene scene;
  Samples samples;
  std::string label;
  std::unique_ptr<draw::Painter> painter;
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
    entry.painter = std::make_unique<draw::Painter>(context, entry.scene, entry.samples,
                                                    glm::uvec2(draw::smallest_picture));
  }
  if (entries.empty())
    throw EnvironmentError("there are no shipped scenes beside this program; name a scene file to play");
  return entries;
}

/// Rows of cells that fill the window, as near to square as they get, with a line between them.
class Grid {
 public:
  Grid(glm::uvec2 window, size_t count) : window_(window), count_(static_cast<uint32_t>(count)) {
    const double square = std::sqrt(static_cast<double>(count) * window.x / window.y);
    columns_ = std::clamp(static_cast<uint32_t>(std::lround(square)), 1u, count_);
  }

  draw::Box cell(size_t k) const {
    const uint32_t rows = (count_ + columns_ - 1) / columns_, row = static_cast<uint32_t>(k) / columns_;
    const uint32_t in_row = std::min(columns_, count_ - row * columns_),
                   column = static_cast<uint32_t>(k) % columns_;
    const auto edge = [](uint32_t whole, uint32_t part, uint32_t parts) {
      const uint32_t pixel = whole * part / parts;
      return static_cast<float>(pixel);
    };
    const float left = edge(window_.x, column, in_row), top = edge(window_.y, row, rows);
    return {left, top, std::max(left, edge(window_.x, column + 1, in_row) - line),
            std::max(top, edge(window_.y, row + 1, rows) - line)};
  }

  std::optional<size_t> at(glm::vec2 place) const {
    for (size_t k = 0; k < count_; ++k) {
      const draw::Box box = cell(k);
      if (place.x >= box.left && place.x < box.right && place.y >= box.top && place.y < box.bottom) return k;
    }
    return std::nullopt;
  }

 private:
  static constexpr float line = 2;
  glm::uvec2 window_;
  uint32_t count_, columns_ = 1;
};

void show(Viewer& viewer, std::vector<Entry>& entries) {
  const glm::uvec2 window = viewer.size();
  const Grid grid(window, entries.size());
  for (size_t k = 0; k < entries.size(); ++k) {
    Entry& entry = entries[k];
    draw::Frame labels;
    labels.text = {entry.label, fmt::format("{}, {} + {}", title_of(entry.scene.method),
                                            entry.samples.fluid.size(), entry.samples.boundary.size())};
    Snapshot state;
    state.x = entry.samples.fluid;
    state.v.resize(state.x.size());
    for (size_t i = 0; i < state.x.size(); ++i)
      state.v[i] = start_velocity(entry.scene, entry.samples, i, state.x[i]);
    const draw::Box cell = grid.cell(k);
    const glm::uvec2 corner(cell.left, cell.top), far(cell.right, cell.bottom);
    entry.painter->renderer().look(glm::max(far - corner, draw::smallest_picture), {});
    entry.painter->paint(std::move(labels), entry.scene.dt, state);
    entry.painter->renderer().show(corner, window.y);
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
    for (const media::WindowEvent& event : viewer.turn(true)) {
      std::optional<size_t> chosen;
      if (event.kind == media::WindowEvent::character && event.typed >= '1' && event.typed <= '9')
        chosen = event.typed - '1';
      if (event.kind == media::WindowEvent::press) chosen = Grid(viewer.size(), entries.size()).at(event.at);
      if (chosen && *chosen < entries.size()) return entries[*chosen].scene.name;
    }
  }
  return std::nullopt;
}

}  // namespace sluice::app
