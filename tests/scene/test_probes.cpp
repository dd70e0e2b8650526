// [[probe]], names of boundary shapes, and particles from a file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/output/output_file.hpp"
#include "core/scene/points_file.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"

namespace sluice::test {
namespace {

std::string refusal_of(std::initializer_list<std::string> overrides) {
  return message_of<InputError>([&] { load_scene("breaking_dam", overrides); });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

TEST(Probes, AreReadWithLengthsInSpacings) {
  const Scene scene = load_scene(
      "breaking_dam", {R"(probe=[{name="P1",at=["2.5h",40]},{name="gauge",x="10h"},{name="front",y=30}])"});
  ASSERT_EQ(scene.probes.size(), 3u);
  EXPECT_EQ(scene.probes[0].at, Vec2(20, 40));
  EXPECT_EQ(scene.probes[1].x, 80);
  EXPECT_EQ(scene.probes[2].y, 30);
  EXPECT_TRUE(load_scene("breaking_dam").probes.empty());
}

TEST(Probes, MistakesAreRefused) {
  EXPECT_TRUE(
      has(refusal_of({R"(probe=[{name="a",x=1,y=2}])"}), "probe.0: found more than one of at, x and y"));
  EXPECT_TRUE(has(refusal_of({R"(probe=[{name="a"}])"}), "found nothing of at, x and y"));
  EXPECT_TRUE(has(refusal_of({R"(probe=[{x=1}])"}), "probe.0.name: found nothing"));
  for (const char* name : {"", "a b", "a,b", "a.b", "\\n"})
    EXPECT_TRUE(has(refusal_of({std::string(R"(probe=[{x=1,name=")") + name + "\"}]"}), "a name of letters"))
        << name;
  EXPECT_TRUE(has(refusal_of({R"(probe=[{name="a",x=1},{name="a",x=2}])"}),
                  "probe.1.name: found \"a\" a second time"));
  EXPECT_TRUE(has(
      refusal_of({R"(boundary.container=[{min=[0,0],max=[9,9],name="w"},{min=[0,0],max=[8,8],name="w"}])"}),
      "boundary.container.1.name: found \"w\" a second time"));
}

class ParticlesFile : public testing::Test {
 protected:
  /// The scene with particles from a file of this text in place of its rect.
  Scene scene_with(const std::string& text, const std::string& more = "") {
    write_file(folder_ / "points.csv", text);
    write_file(folder_ / "mine.toml", R"(
      scene.title = "mine"
      particles = {spacing = 1, rest_density = 1}
      domain = {min = [0, 0], max = [20, 20]}
      pressure.method = "iisph"
      time = {dt = 0.01, duration = 1}
      [fluid]
      gravity = [0, -1]
      [[fluid.particles]]
      file = "points.csv"
      )" + more);
    return load_scene(folder_ / "mine.toml");
  }
  std::string refusal_of(const std::string& text) {
    return message_of<InputError>([&] { scene_with(text); });
  }
  TemporaryFolder folder_;
};

TEST_F(ParticlesFile, HasPlacesAndVelocitiesAndColumnsThatDoNotMatter) {
  const Scene scene = scene_with("id,vy,x,y,vx,density\r\n0,4,1.5,2,3,9\r\n1,0,5,6,-1,9\n",
                                 "velocity = [10, 0]\n[[fluid.rect]]\nmin = [10, 10]\ncount = [2, 1]\n");
  const Samples samples = sample(scene);
  EXPECT_EQ(samples.fluid, (std::vector<Vec2>{{1.5, 2}, {5, 6}, {10, 10}, {11, 10}}));
  EXPECT_EQ(start_velocity(scene, samples, 0, samples.fluid[0]), Vec2(13, 4));
  EXPECT_EQ(start_velocity(scene, samples, 1, samples.fluid[1]), Vec2(9, 0));
  EXPECT_EQ(start_velocity(scene, samples, 3, samples.fluid[3]), Vec2(0, 0));
}

TEST_F(ParticlesFile, MayBeCloserThanHalfASpacingButNotToOtherShapes) {
  EXPECT_EQ(sample(scene_with("x,y\n1,1\n1.2,1\n")).fluid.size(), 2u);
  const Scene both = scene_with("x,y\n10.2,10\n", "[[fluid.rect]]\nmin = [10, 10]\ncount = [2, 1]\n");
  EXPECT_TRUE(
      has(message_of<InputError>([&] { sample(both); }), "within half a spacing of fluid.particles.0"));
}

TEST_F(ParticlesFile, MistakesAreSaidWithFileAndLine) {
  EXPECT_TRUE(
      has(refusal_of("a,b\n1,2\n"), "points.csv, whose first line does not name the columns x and y"));
  EXPECT_TRUE(has(refusal_of("x,y\n1,2\n3\n"), "points.csv:3, which has no finite number y"));
  EXPECT_TRUE(has(refusal_of("x,y\n1,nan\n"), "points.csv:2, which has no finite number y"));
  EXPECT_TRUE(has(refusal_of("x,y,vx\n1,2,fast\n"), "points.csv:2, which has no finite number vx"));
  EXPECT_TRUE(has(refusal_of(""), "points.csv, which can't be read"));
  EXPECT_TRUE(has(refusal_of("x,y\n1,2\n3\n"), "mine.toml:10:"));
  EXPECT_TRUE(has(message_of<InputError>([&] { sample(scene_with("x,y\n")); }), "found no particle in it"));
  EXPECT_TRUE(has(message_of<InputError>([] { read_points("/dev/zero"); }), "can't be read"));
}

}  // namespace
}  // namespace sluice::test
