// Text and colour bars: they keep to their panels, and the bar shows the colours of the particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sluice/error.hpp"
#include "tests/support/picture_test.hpp"

namespace sluice::test {
namespace {

using draw::bar_labels;

// Pixels of two pictures that differ: how many inside the box and outside.
std::pair<int, int> differences(const draw::Image& a, const draw::Image& b, const draw::Box& box) {
  std::pair<int, int> count{0, 0};
  for (uint32_t y = 0; y < a.height; ++y) {
    for (uint32_t x = 0; x < a.width; ++x) {
      if (pixel(a, x, y) == pixel(b, x, y)) continue;
      const auto px = static_cast<float>(x), py = static_cast<float>(y);
      const bool inside = px >= box.left && px < box.right && py >= box.top && py < box.bottom;
      (inside ? count.first : count.second) += 1;
    }
  }
  return count;
}

class OverlayTest : public PictureTest {
 protected:
  OverlayTest() {
    for (int k = 0; k < 900; ++k) fluid.push_back({(k % 30) * 10.0 + 5, (k / 30) * 10.0 + 5});
    for (size_t k = 0; k < fluid.size(); ++k) values.push_back(static_cast<double>(k) / 900);
  }
  std::vector<Vec2> fluid;
  std::vector<double> values;
};

TEST_F(OverlayTest, TextChangesOnlyItsPanel) {
  draw::Renderer renderer(context, {300, 300}, {0, 0}, {300, 300}, 10);
  draw::Frame shown = frame(fluid, values);
  const draw::Image plain = renderer.draw(shown);
  shown.text = {"Breaking dam", "t = 1.25 s, Öl \xff ρ₀ \xe6\xb0\xb4",
                "A line with words enough to be wrapped at the edge"};
  const draw::Image written = renderer.draw(shown);
  ASSERT_TRUE(renderer.panels().text.has_value());
  const draw::Box panel = *renderer.panels().text;
  const auto [inside, outside] = differences(plain, written, panel);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(inside, static_cast<int>(0.5f * (panel.right - panel.left) * (panel.bottom - panel.top)));
  int dark = 0;
  for (auto y = static_cast<uint32_t>(panel.top); y < static_cast<uint32_t>(panel.bottom); ++y) {
    for (auto x = static_cast<uint32_t>(panel.left); x < static_cast<uint32_t>(panel.right); ++x) {
      const Pixel found = pixel(written, x, y);
      dark += found[0] < 90 && found[1] < 90 && found[2] < 90 ? 1 : 0;
    }
  }
  EXPECT_GT(dark, 200) << "no ink";
  shown.text[1][4] = '2';
  EXPECT_GT(differences(written, renderer.draw(shown), panel).first, 0) << "the text has no influence";
}

TEST_F(OverlayTest, TheBarShowsTheColoursOfTheParticles) {
  for (const Colour colour : {Colour::speed, Colour::density, Colour::pressure}) {
    draw::Renderer renderer(context, {300, 300}, {0, 0}, {300, 300}, 10);
    draw::Frame shown = frame(fluid, values);
    shown.colour = colour;
    shown.low = colour == Colour::speed ? 77 : -2;  // speed takes no notice
    shown.high = colour == Colour::speed ? 99 : 3;
    const draw::Image plain = renderer.draw(shown);
    shown.colour_bar = true;
    const draw::Image image = renderer.draw(shown);
    ASSERT_TRUE(renderer.panels().gradient.has_value());
    EXPECT_EQ(differences(plain, image, *renderer.panels().colour_bar).second, 0);
    const draw::Box gradient = *renderer.panels().gradient;
    const auto left = static_cast<uint32_t>(gradient.left), right = static_cast<uint32_t>(gradient.right) - 1;
    const double low = colour == Colour::speed ? 0 : -2, high = colour == Colour::speed ? 1 : 3;
    for (const uint32_t x : {left, (2 * left + right) / 3, (left + right) / 2, right}) {
      const double value = low + (high - low) * (x - left) / (right - left);
      draw::Frame single = frame({}, {});
      const std::vector<Vec2> centre{{150, 150}};
      const std::vector<double> one{value};
      single.fluid = centre;
      single.value = one;
      single.colour = colour;
      single.low = -2;
      single.high = 3;
      const Pixel expected = pixel(renderer.draw(single), 150, 150);
      for (const float y : {gradient.top, gradient.bottom - 1}) {
        expect_near(pixel(image, x, static_cast<uint32_t>(y)), expected,
                    "bar at value " + std::to_string(value));
      }
    }
  }
}

TEST_F(OverlayTest, TheMapRunsFromDarkToLight) {
  std::vector<int> lightness;
  for (int k = -1; k <= 11; ++k) {
    draw::Renderer renderer(context, {32, 32}, {0, 0}, {32, 32}, 20);
    const std::vector<Vec2> centre{{16, 16}};
    const std::vector<double> one{0.998 + 0.0004 * k};
    draw::Frame shown = frame(centre, one);
    shown.colour = Colour::density;
    shown.low = 0.998;
    shown.high = 1.002;
    const Pixel found = pixel(renderer.draw(shown), 16, 16);
    lightness.push_back(2 * found[0] + 5 * found[1] + found[2]);
  }
  EXPECT_EQ(lightness[0], lightness[1]) << "values below the range take the colour of its end";
  EXPECT_EQ(lightness[11], lightness[12]) << "values above the range take the colour of its end";
  for (size_t k = 2; k <= 11; ++k) EXPECT_GT(lightness[k], lightness[k - 1] + 20) << k;
}

TEST_F(OverlayTest, LabelsTellTheNumbersApart) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(draw::bar_labels(0, 1), (Labels{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(draw::bar_labels(0.999, 1.001), (Labels{"0.999", "1.000", "1.001"}));
  EXPECT_EQ(draw::bar_labels(0, 1766), (Labels{"0", "883", "1766"}));
  EXPECT_EQ(draw::bar_labels(0, 3e7), (Labels{"0.0e+00", "1.5e+07", "3.0e+07"}));
  EXPECT_EQ(draw::bar_labels(0, 2e-5), (Labels{"0e+00", "1e-05", "2e-05"}));
  EXPECT_EQ(draw::bar_labels(0, 0), (Labels{"0", "0", "0"}));
}

TEST_F(OverlayTest, TheBarAtTheBottomIsAsFullAsTheRecordingWasPlayed) {
  draw::Renderer renderer(context, {300, 300}, {0, 0}, {300, 300}, 10);
  draw::Frame shown = frame({}, {});
  const draw::Image plain = renderer.draw(shown);
  EXPECT_FALSE(renderer.panels().timeline.has_value());
  for (const double played : {0.0, 0.25, 1.0}) {
    shown.played = played;
    const draw::Image image = renderer.draw(shown);
    ASSERT_TRUE(renderer.panels().timeline.has_value());
    const draw::Box bar = *renderer.panels().timeline;
    EXPECT_EQ(differences(plain, image, bar).second, 0) << "it leaves the rest alone";
    EXPECT_GT(bar.top, 270);
    const auto y = static_cast<uint32_t>((bar.top + bar.bottom) / 2);
    for (const float place : {0.01f, 0.24f, 0.26f, 0.99f}) {
      const auto x = static_cast<uint32_t>(bar.left + place * (bar.right - bar.left));
      EXPECT_EQ(pixel(image, x, y)[0] < 200, double(place) < played) << place << " of " << played;
    }
  }
}

TEST_F(OverlayTest, LongTextMayCoverMoreThanHalf) {
  draw::Renderer renderer(context, {300, 300}, {0, 0}, {300, 300}, 10);
  draw::Frame shown = frame({}, {});
  shown.text.assign(14, "a line");
  renderer.draw(shown);
  const float half = renderer.panels().text->bottom;
  EXPECT_LE(half, 150);
  shown.long_text = true;
  renderer.draw(shown);
  EXPECT_GT(renderer.panels().text->bottom, 150);
  EXPECT_LE(renderer.panels().text->bottom, 300);
}

TEST_F(OverlayTest, PanelsLeaveHalfOfThePictureFree) {
  for (const glm::uvec2 size :
       {glm::uvec2(16, 16), glm::uvec2(40, 60), glm::uvec2(100, 100), glm::uvec2(200, 900)}) {
    draw::Renderer renderer(context, size, Vec2(0), Vec2(size), 3);
    draw::Frame shown = frame({}, {});
    shown.text = std::vector<std::string>(100, "many long lines, more than fit");
    shown.colour_bar = true;
    const draw::Image image = renderer.draw(shown);
    EXPECT_EQ(image.rgb.size(), size_t{size.x} * size.y * 3);
    for (const auto& panel : {renderer.panels().text, renderer.panels().colour_bar}) {
      if (!panel) continue;
      EXPECT_LE(panel->bottom, static_cast<float>(size.y) / 2);
      EXPECT_LE(panel->right, static_cast<float>(size.x));
    }
    for (uint32_t y = (size.y + 1) / 2; y < size.y; ++y) ASSERT_EQ(pixel(image, size.x / 2, y), white);
  }
}

}  // namespace
}  // namespace sluice::test
