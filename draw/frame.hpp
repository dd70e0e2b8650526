// What a picture shows of one moment of a run, without saying how it is drawn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sluice/scene.hpp"

namespace sluice::draw {

/// One moment of the fluid. The spans have the same length and are only read during the call they are given
/// to.
struct Frame {
  std::span<const Vec2> fluid;    ///< positions
  std::span<const double> value;  ///< |v| dt/h for speed, rho/rho0 for density, p for pressure
  Colour colour = Colour::speed;
  double low = 0, high = 1;       ///< values at the ends of the colour bar; speed has its own, 0 and 1
  std::vector<std::string> text;  ///< lines in the top left corner, UTF-8
  bool colour_bar = false;
  bool long_text = false;        ///< the text may cover more than the upper half
  std::optional<double> played;  ///< shown on a bar at the bottom: how much of a recording, from 0 to 1
};

}  // namespace sluice::draw
