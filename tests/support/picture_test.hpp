// The fixture of the tests that draw: a context that must stay free of complaints, and pixels to look at.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "draw/renderer.hpp"
#include "gpu/context.hpp"

namespace sluice::test {

using draw::Box;
using draw::ParticleShape;
using draw::Renderer;
using gpu::Context;
using Pixel = std::array<int, 3>;
inline constexpr Pixel white{255, 255, 255};
inline constexpr double red_speed = 2;  // |v| dt/h beyond 1: pure red, so that 255 - green is the coverage

class PictureTest : public testing::Test {
 protected:
  void TearDown() override { EXPECT_NO_THROW(context.check("the test")); }

  // A picture of the view (0, 0) - size, one pixel per unit.
  draw::Image draw(glm::uvec2 size, double diameter, const std::vector<Vec2>& fluid, double value = red_speed,
                   draw::ParticleShape shape = draw::ParticleShape::automatic) {
    draw::Renderer renderer(context, size, Vec2(0), Vec2(size), diameter, shape);
    const std::vector<double> values(fluid.size(), value);
    return renderer.draw(frame(fluid, values));
  }

  static draw::Frame frame(const std::vector<Vec2>& fluid, const std::vector<double>& values) {
    draw::Frame result;
    result.fluid = fluid;
    result.value = values;
    return result;
  }

  Context context;
};

inline Pixel pixel(const draw::Image& image, uint32_t x, uint32_t y) {
  const size_t at = (size_t{y} * image.width + x) * 3;
  return {image.rgb.at(at), image.rgb.at(at + 1), image.rgb.at(at + 2)};
}

inline void expect_near(const Pixel& found, const Pixel& expected, const std::string& what) {
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1) << what << ", channel " << k;
}

}  // namespace sluice::test
