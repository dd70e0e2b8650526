// Pictures show what they should: colours, areas, places, and the same bytes each time.
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

constexpr double pi = std::numbers::pi;

// Area and centre of gravity, in pixels with y down, of what is red on white.
struct Blot {
  double area = 0;
  Vec2 centre{};
};

Blot blot(const draw::Image& image) {
  Blot result;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      const double coverage = (255 - pixel(image, x, y)[1]) / 255.0;
      result.area += coverage;
      result.centre += coverage * Vec2(x + 0.5, y + 0.5);
    }
  }
  result.centre /= result.area;
  return result;
}

TEST_F(PictureTest, SpeedColoursFollowTheEquation) {
  for (const double s : {0.0, 0.1, 0.25, 0.4, 0.4999, 0.5, 0.6, 0.75, 0.9, 1.0, 1.5, 2.0}) {
    const double sine2 = std::sin(pi * s) * std::sin(pi * s), cosine2 = std::cos(pi * s) * std::cos(pi * s);
    const auto byte = [](double part) { return static_cast<int>(std::lround(255 * part)); };
    Pixel expected{255, 0, 0};
    if (s < 0.5) expected = {0, byte(sine2), byte(cosine2)};
    if (s >= 0.5 && s < 1) expected = {byte(cosine2), byte(sine2), 0};
    expect_near(pixel(draw({32, 32}, 20, {{16, 16}}, s), 16, 16), expected, "s = " + std::to_string(s));
  }
}

TEST_F(PictureTest, CirclesHaveTheirArea) {
  for (const auto shape : {draw::ParticleShape::automatic, draw::ParticleShape::quads}) {
    for (const double diameter : {0.3, 0.5, 0.9, 1.0, 1.1, 1.5, 2.0, 3.0, 5.5, 8.0, 21.0, 40.0}) {
      for (const Vec2 centre : {Vec2(32, 32), Vec2(31.5, 32.5), Vec2(32.3, 31.1), Vec2(30.77, 33.93)}) {
        const Blot found = blot(draw({64, 64}, diameter, {centre}, red_speed, shape));
        const double area = pi * diameter * diameter / 4;
        // Eight rows in a pixel are a coarse rule for a circle that is hardly more than a pixel.
        const double share = diameter < 3 ? 0.03 : 0.01;
        EXPECT_NEAR(found.area, area, share * area + 0.01) << "diameter " << diameter << " at " << centre.x;
        EXPECT_NEAR(found.centre.x, centre.x, diameter < 3 ? 0.07 : 0.02) << "diameter " << diameter;
        EXPECT_NEAR(found.centre.y, 64 - centre.y, diameter < 3 ? 0.07 : 0.02) << "diameter " << diameter;
      }
    }
  }
}

TEST_F(PictureTest, CirclesAreRound) {
  const draw::Image image = draw({64, 64}, 41, {{32, 32}});
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const double distance = std::hypot(x + 0.5 - 32, y + 0.5 - 32);
      const int green = pixel(image, x, y)[1];
      if (distance < 20.5 - 0.75) {
        EXPECT_EQ(green, 0) << x << ", " << y;
      }
      if (distance > 20.5 + 0.75) {
        EXPECT_EQ(green, 255) << x << ", " << y;
      }
    }
  }
}

TEST_F(PictureTest, SpritesAndQuadsGiveTheSameBytes) {
  std::vector<Vec2> fluid;
  for (int k = 0; k < 200; ++k)
    fluid.push_back({60 + 65 * std::sin(k * 1.7), 50 + 55 * std::sin(k * 2.9 + 1)});
  for (const double diameter : {0.4, 1.0, 7.3, 30.0, 240.0}) {
    const draw::Image sprites = draw({120, 100}, diameter, fluid, 0.3, draw::ParticleShape::automatic);
    const draw::Image quads = draw({120, 100}, diameter, fluid, 0.3, draw::ParticleShape::quads);
    EXPECT_TRUE(sprites.rgb == quads.rgb) << "diameter " << diameter;
  }
}

TEST_F(PictureTest, CirclesLargerThanAnySprite) {
  const Blot found = blot(draw({700, 700}, 600, {{350, 340}}));
  EXPECT_NEAR(found.area, pi * 300 * 300, 30);
  EXPECT_NEAR(found.centre.y, 360, 0.01);
}

// A particle whose centre has left the picture is still seen as long as its circle reaches in.
TEST_F(PictureTest, CirclesAreCutAtTheEdgeOfThePicture) {
  constexpr double radius = 15, outside = 6;
  const double segment = radius * radius * std::acos(outside / radius) -
                         outside * std::sqrt(radius * radius - outside * outside);
  for (const auto shape : {draw::ParticleShape::automatic, draw::ParticleShape::quads}) {
    for (const Vec2 centre :
         {Vec2(-outside, 40), Vec2(80 + outside, 40), Vec2(40, -outside), Vec2(40, 80 + outside)}) {
      const Blot found = blot(draw({80, 80}, 2 * radius, {centre}, red_speed, shape));
      EXPECT_NEAR(found.area, segment, 0.01 * segment) << centre.x << ", " << centre.y;
    }
    EXPECT_NEAR(blot(draw({80, 80}, 2 * radius, {{0, 80}}, red_speed, shape)).area, pi * radius * radius / 4,
                1);
    EXPECT_EQ(blot(draw({80, 80}, 2 * radius, {{-15.1, 40}, {40, 95.1}}, red_speed, shape)).area, 0);
  }
}

TEST_F(PictureTest, PlacesAreExactInOddSizes) {
  for (const glm::uvec2 size :
       {glm::uvec2(16, 16), glm::uvec2(17, 33), glm::uvec2(401, 599), glm::uvec2(50, 19)}) {
    for (const Vec2 part : {Vec2(0.2, 0.2), Vec2(0.8, 0.3), Vec2(0.5, 0.75)}) {
      const Vec2 place = part * Vec2(size);
      const draw::Image image = draw(size, 4, {place});
      ASSERT_EQ(image.width, size.x);
      ASSERT_EQ(image.height, size.y);
      ASSERT_EQ(image.rgb.size(), size_t{size.x} * size.y * 3);
      const Blot found = blot(image);
      EXPECT_NEAR(found.centre.x, place.x, 0.02) << size.x << " x " << size.y;
      EXPECT_NEAR(found.centre.y, size.y - place.y, 0.02) << size.x << " x " << size.y;  // y is up
    }
  }
}

TEST_F(PictureTest, TheViewKeepsItsProportionsAndIsCentred) {
  const std::vector<Vec2> fluid{{10, 20}};
  const std::vector<double> values{red_speed};
  draw::Renderer wide(context, {300, 100}, {0, 0}, {50, 50}, 10);  // scale 2, view at x = 100..200
  const draw::Image image = wide.draw(frame(fluid, values));
  const Pixel shade = pixel(image, 0, 50);
  EXPECT_LT(shade[0], 250);
  EXPECT_EQ(pixel(image, 99, 50), shade);
  EXPECT_EQ(pixel(image, 100, 50), white);
  EXPECT_EQ(pixel(image, 199, 50), white);
  EXPECT_EQ(pixel(image, 200, 50), shade);
  EXPECT_EQ(pixel(image, 299, 99), shade);
  for (const auto& [x, y] :
       {std::pair{111u, 60u}, {128u, 60u}, {120u, 51u}, {120u, 68u}}) {  // circle of 20 pixels
    EXPECT_EQ(pixel(image, x, y), (Pixel{255, 0, 0})) << x << ", " << y;
  }
  for (const auto& [x, y] : {std::pair{108u, 60u}, {131u, 60u}, {120u, 48u}, {120u, 71u}}) {
    EXPECT_EQ(pixel(image, x, y), white) << x << ", " << y;
  }

  draw::Renderer tall(context, {100, 300}, {0, 0}, {50, 50}, 10);
  const draw::Image upright = tall.draw(frame(fluid, values));
  EXPECT_EQ(pixel(upright, 50, 99), shade);
  EXPECT_EQ(pixel(upright, 50, 100), white);
  EXPECT_EQ(pixel(upright, 50, 199), white);
  EXPECT_EQ(pixel(upright, 50, 200), shade);
  EXPECT_EQ(pixel(upright, 20, 160), (Pixel{255, 0, 0}));
}

TEST_F(PictureTest, ACameraEnlargesAndMoves) {
  const std::vector<Vec2> fluid{{20, 20}};  // in the middle of the view, at pixel (30, 20)
  const std::vector<double> values{red_speed};
  draw::Renderer renderer(context, {60, 40}, {0, 0}, {40, 40}, 6);
  const draw::Image plain = renderer.draw(frame(fluid, values));
  const Pixel shade = pixel(plain, 0, 0), red{255, 0, 0};
  renderer.look({60, 40}, {2, {-10, -10}});  // a circle of 12 pixels about (50, 30), the view from x = 10 on
  const draw::Image image = renderer.draw(frame(fluid, values));
  for (const auto& [x, y] : {std::pair{50u, 30u}, {45u, 30u}, {54u, 30u}, {50u, 25u}, {50u, 34u}})
    EXPECT_EQ(pixel(image, x, y), red) << x << ", " << y;
  for (const auto& [x, y] : {std::pair{42u, 30u}, {57u, 30u}, {50u, 22u}, {50u, 37u}, {10u, 20u}, {59u, 0u}})
    EXPECT_EQ(pixel(image, x, y), white) << x << ", " << y;
  EXPECT_EQ(pixel(image, 9, 20), shade);
  renderer.look({60, 40}, {});
  EXPECT_TRUE(renderer.draw(frame(fluid, values)).rgb == plain.rgb);
}

TEST_F(PictureTest, APictureOfAnotherSizeIsThatOfARendererMadeForIt) {
  const std::vector<Vec2> fluid{{20, 20}, {3, 5}, {39, 39}};
  const std::vector<double> values{0.2, 0.5, red_speed};
  draw::Frame shown = frame(fluid, values);
  shown.colour = Colour::density;
  shown.text = {"Two lines", "of text"};
  shown.colour_bar = true;
  draw::Renderer renderer(context, {60, 40}, {0, 0}, {40, 40}, 6);
  renderer.set_boundary(fluid);
  renderer.draw(shown);
  for (const glm::uvec2 size : {glm::uvec2(300, 700), {900, 620}, {60, 40}}) {
    draw::Renderer made(context, size, {0, 0}, {40, 40}, 6);
    made.set_boundary(fluid);
    renderer.look(size, {});
    const draw::Image image = renderer.draw(shown);
    EXPECT_EQ(glm::uvec2(image.width, image.height), size);
    EXPECT_TRUE(image.rgb == made.draw(shown).rgb) << size.x << " x " << size.y;
  }
  EXPECT_THROW(renderer.look({8, 8}, {}), InputError);
}

TEST_F(PictureTest, FarFromTheOriginNothingChanges) {
  std::vector<Vec2> near, far;
  std::vector<double> values;
  const Vec2 away(1e9, -3e9);
  for (int k = 0; k < 50; ++k) {
    near.push_back({k * 1.25, 32 + 30 * std::sin(k)});
    near.back() = Vec2(std::round(near.back().x * 1024), std::round(near.back().y * 1024)) / 1024.0;
    far.push_back(near.back() + away);
    values.push_back(k / 50.0);
  }
  draw::Renderer here(context, {64, 64}, {0, 0}, {64, 64}, 6);
  draw::Renderer there(context, {64, 64}, away, away + Vec2(64), 6);
  here.set_boundary(near);
  there.set_boundary(far);
  EXPECT_TRUE(here.draw(frame(near, values)).rgb == there.draw(frame(far, values)).rgb);
}

TEST_F(PictureTest, TheBoundaryIsGreyBelowTheFluid) {
  draw::Renderer renderer(context, {64, 32}, {0, 0}, {64, 32}, 20);
  const std::vector<Vec2> boundary{{16, 16}, {48, 16}};
  const std::vector<Vec2> fluid{{48, 16}};
  renderer.set_boundary(boundary);
  const draw::Image image = renderer.draw(frame(fluid, {red_speed}));
  const Pixel grey = pixel(image, 16, 16);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  EXPECT_GT(grey[0], 100);
  EXPECT_LT(grey[0], 200);
  EXPECT_EQ(pixel(image, 48, 16), (Pixel{255, 0, 0}));
  EXPECT_EQ(pixel(image, 32, 16), white);
  renderer.set_boundary({});
  EXPECT_EQ(pixel(renderer.draw(frame(fluid, {red_speed})), 16, 16), white);
}

TEST_F(PictureTest, FramesLeaveNothingBehind) {
  draw::Renderer renderer(context, {90, 60}, {0, 0}, {90, 60}, 5);
  std::vector<Vec2> many;
  for (int k = 0; k < 500; ++k) many.push_back({45 + 50 * std::sin(k * 1.3), 30 + 35 * std::cos(k * 2.1)});
  const std::vector<Vec2> few(many.begin(), many.begin() + 20);
  const std::vector<double> slow(many.size(), 0.2), fast(few.size(), 0.9);
  renderer.set_boundary(few);
  const draw::Image first = renderer.draw(frame(many, slow));
  const draw::Image second = renderer.draw(frame(few, fast));
  EXPECT_FALSE(first.rgb == second.rgb);
  draw::Frame decorated = frame(many, slow);
  decorated.text = {"text"};
  decorated.colour_bar = true;
  decorated.colour = Colour::pressure;
  renderer.draw(decorated);
  EXPECT_TRUE(renderer.draw(frame(many, slow)).rgb == first.rgb);
  EXPECT_TRUE(renderer.draw(frame(few, fast)).rgb == second.rgb);
  EXPECT_FALSE(renderer.panels().text.has_value());
}

TEST_F(PictureTest, AnEmptyFrameIsAllowed) {
  draw::Renderer renderer(context, {20, 20}, {0, 0}, {20, 20}, 5);
  const draw::Image image = renderer.draw(draw::Frame{});
  EXPECT_TRUE(std::ranges::all_of(image.rgb, [](uint8_t byte) { return byte == 255; }));
}

TEST_F(PictureTest, TwoContextsDoNotMix) {
  Context other;
  draw::Renderer first(context, {40, 40}, {0, 0}, {40, 40}, 9);
  const std::vector<Vec2> fluid{{11, 13}, {30, 22}};
  const std::vector<double> values{0.3, 0.3};
  const draw::Frame shown = frame(fluid, values);
  const draw::Image expected = first.draw(shown);
  {
    draw::Renderer second(other, {40, 40}, {0, 0}, {40, 40}, 9);
    EXPECT_TRUE(second.draw(shown).rgb == expected.rgb);
    EXPECT_TRUE(first.draw(shown).rgb == expected.rgb);
    context.make_current();  // the second renderer now goes while the first one's context is current
  }
  EXPECT_TRUE(first.draw(shown).rgb == expected.rgb);
  EXPECT_NO_THROW(other.check("the other context"));
}

TEST_F(PictureTest, ImpossiblePicturesAreBadInput) {
  const auto message = [&](glm::uvec2 size, Vec2 low, Vec2 high) -> std::string {
    try {
      draw::Renderer renderer(context, size, low, high, 1);
    } catch (const sluice::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({15, 100}, {0, 0}, {1, 1}).find("15 x 100"), std::string::npos);
  EXPECT_NE(message({100, 1u << 20}, {0, 0}, {1, 1}).find("choose 16 to "), std::string::npos);
  EXPECT_NE(message({100, 100}, {0, 0}, {0, 1}).find("domain"), std::string::npos);
  EXPECT_NE(message({100, 100}, {0, 0}, {1e308, HUGE_VAL}).find("domain"), std::string::npos);
  EXPECT_EQ(message({16, 16}, {0, 0}, {1, 1}), "");
}

TEST_F(PictureTest, ValuesMustMatchParticles) {
  draw::Renderer renderer(context, {20, 20}, {0, 0}, {20, 20}, 5);
  EXPECT_THROW(renderer.draw(frame({{1, 1}, {2, 2}}, {0.5})), sluice::Error);
}

}  // namespace
}  // namespace sluice::test
