// Layout of the overlay's panels.
#include "draw/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sluice::draw {
namespace {

constexpr glm::vec4 ink{0.13f, 0.13f, 0.16f, 1.0f};
constexpr glm::vec4 paper{1.0f, 1.0f, 1.0f, 0.82f};
constexpr glm::vec4 done{0.13f, 0.13f, 0.16f, 0.6f};
constexpr glm::vec4 outline{0.0f, 0.0f, 0.0f, 0.3f};

void add_frame(Overlay& overlay, const Box& box) {
  overlay.add_box({box.left, box.top, box.right, box.top + 1}, outline);
  overlay.add_box({box.left, box.bottom - 1, box.right, box.bottom}, outline);
  overlay.add_box({box.left, box.top + 1, box.left + 1, box.bottom - 1}, outline);
  overlay.add_box({box.right - 1, box.top + 1, box.right, box.bottom - 1}, outline);
}

// Breaks a line at blanks so that it fits; a single word that is too long stays whole.
std::vector<std::string> wrapped(const Overlay& overlay, const std::string& line, float width) {
  std::vector<std::string> lines(1);
  size_t begin = 0;
  while (begin <= line.size()) {
    const size_t end = std::min(line.find(' ', begin), line.size());
    const std::string word = line.substr(begin, end - begin);
    std::string& last = lines.back();
    const std::string longer = begin == 0 ? word : last + " " + word;
    if (last.empty() || overlay.width(longer) <= width) {
      last = longer;
    } else {
      lines.push_back(word);
    }
    begin = end + 1;
  }
  return lines;
}

const char* bar_name(Colour colour) {
  switch (colour) {
    case Colour::speed: return "speed: |v| dt/h";
    case Colour::density: return "density: ρ/ρ₀";
    case Colour::pressure: return "pressure";
  }
  return "";
}

// What both panels need to know.
struct Layout {
  Overlay& overlay;
  glm::vec2 picture;
  bool long_text;
  float gap = std::round(overlay.font_size() * 0.5f);  // around panels and inside them

  float lowest() const { return long_text ? picture.y : std::floor(picture.y / 2); }
  float widest_line() const { return picture.x - 4 * gap; }
};

std::optional<Box> add_text_panel(const Layout& layout, const std::vector<std::string>& text) {
  Overlay& overlay = layout.overlay;
  const float gap = layout.gap;
  std::vector<std::string> lines;
  for (const std::string& line : text) {
    for (std::string& part : wrapped(overlay, line, layout.widest_line())) lines.push_back(std::move(part));
  }
  const float room = (layout.lowest() - 3 * gap) / overlay.line_height();
  lines.resize(std::min(lines.size(), static_cast<size_t>(std::max(room, 0.0f))));
  if (lines.empty()) return std::nullopt;
  float width = 0;
  for (const std::string& line : lines) width = std::max(width, std::ceil(overlay.width(line)));
  width = std::min(width, layout.widest_line());
  const float height = static_cast<float>(lines.size()) * overlay.line_height();
  const Box panel{gap, gap, 3 * gap + width, 3 * gap + height};
  overlay.add_box(panel, paper);
  add_frame(overlay, panel);
  for (size_t k = 0; k < lines.size(); ++k) {
    overlay.add_text(2 * gap, 2 * gap + static_cast<float>(k) * overlay.line_height(), lines[k], ink);
  }
  return panel;
}

// The name, the gradient below it, three numbers below that.
void add_bar_panel(const Layout& layout, const Frame& frame, Panels& panels) {
  Overlay& overlay = layout.overlay;
  const float gap = layout.gap;
  const std::string name = bar_name(frame.colour);
  const bool speed = frame.colour == Colour::speed;
  const auto labels = speed ? bar_labels(0, 1) : bar_labels(frame.low, frame.high);
  const float first = overlay.width(labels[0]), middle = overlay.width(labels[1]),
              last = overlay.width(labels[2]);
  float width = std::max({11 * overlay.font_size(), overlay.width(name), first + last + 2 * gap});
  width = std::min(std::round(width), layout.widest_line());
  const float line = overlay.line_height();
  const float small_gap = std::round(0.2f * overlay.font_size());
  const float thickness = std::round(0.8f * overlay.font_size());
  const float height = 2 * line + thickness + small_gap;

  Box panel{layout.picture.x - 3 * gap - width, gap, layout.picture.x - gap, 3 * gap + height};
  if (panels.text && panels.text->right + gap > panel.left) {
    const float top = panels.text->bottom + gap;
    panel = {gap, top, 3 * gap + width, top + 2 * gap + height};
  }
  if (panel.bottom > layout.lowest() || std::max(overlay.width(name), first + last) > width) return;
  const float left = panel.left + gap;
  const float top = panel.top + gap;
  const Box gradient{left, top + line + small_gap, left + width, top + line + small_gap + thickness};
  overlay.add_box(panel, paper);
  add_frame(overlay, panel);
  add_frame(overlay, {gradient.left - 1, gradient.top - 1, gradient.right + 1, gradient.bottom + 1});
  overlay.add_text(left, top, name, ink);
  const float below = gradient.bottom + small_gap;
  overlay.add_text(left, below, labels[0], ink);
  overlay.add_text(left + width - last, below, labels[2], ink);
  if (std::max(first, last) + middle / 2 + gap < width / 2) {
    overlay.add_text(std::round(left + (width - middle) / 2), below, labels[1], ink);
  }
  panels.colour_bar = panel;
  panels.gradient = gradient;
}

void add_timeline(const Layout& layout, double played, Panels& panels) {
  const float gap = layout.gap, height = std::round(0.8f * layout.overlay.font_size());
  const Box bar{gap, layout.picture.y - gap - height, layout.picture.x - gap, layout.picture.y - gap};
  const float now = std::round(bar.left + static_cast<float>(played) * (bar.right - bar.left));
  layout.overlay.add_box(bar, paper);
  layout.overlay.add_box({bar.left, bar.top, now, bar.bottom}, done);
  add_frame(layout.overlay, bar);
  panels.timeline = bar;
}

}  // namespace

std::vector<std::string> bar_labels(double low, double high) {
  const std::array<double, 3> values{low, low + (high - low) / 2, high};
  const double largest = std::max(std::abs(low), std::abs(high));
  const bool plain = largest < 1e6 && (largest >= 1e-3 || largest == 0);
  std::vector<std::string> labels;
  for (int digits = 0; digits <= 9; ++digits) {
    labels.clear();
    bool exact = true;
    for (const double value : values) {
      labels.push_back(plain ? fmt::format("{:.{}f}", value, digits) : fmt::format("{:.{}e}", value, digits));
      exact = exact && std::abs(std::stod(labels.back()) - value) <= 0.01 * (high - low);
    }
    if (exact) break;
  }
  return labels;
}

Panels add_panels(Overlay& overlay, glm::uvec2 picture, const Frame& frame) {
  const Layout layout{overlay, glm::vec2(picture), frame.long_text};
  Panels panels;
  panels.text = add_text_panel(layout, frame.text);
  if (frame.colour_bar) add_bar_panel(layout, frame, panels);
  if (frame.played) add_timeline(layout, *frame.played, panels);
  return panels;
}

}  // namespace sluice::draw
