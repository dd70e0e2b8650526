// Where the overlay's panels go: the text at the top left, the colour bar beside it or, in a narrow picture,
// below;
// how far a recording was played at the bottom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/frame.hpp"
#include "draw/overlay.hpp"

namespace sluice::draw {

/// The areas that panels cover, and the gradient of the colour bar inside its panel.
struct Panels {
  std::optional<Box> text;
  std::optional<Box> colour_bar;
  std::optional<Box> gradient;
  std::optional<Box> timeline;
};

/// Adds the frame's panels to the overlay. Long lines are wrapped; together the panels take at most half of
/// the picture's height, or with Frame::long_text all of it, and lines or a bar beyond that are left out.
Panels add_panels(Overlay& overlay, glm::uvec2 picture, const Frame& frame);

/// Texts of three numbers, for the ends and the middle of a bar, with as many digits as place them within a
/// hundredth of the bar.
std::vector<std::string> bar_labels(double low, double high);

}  // namespace sluice::draw
