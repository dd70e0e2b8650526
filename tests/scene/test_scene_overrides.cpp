// --set KEY=VALUE: what it changes, that the order of keys doesn't matter, and how its mistakes are reported.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/scene/settings.hpp"
#include "sluice/load.hpp"

namespace sluice {
namespace {

using Overrides = std::vector<std::string>;

const std::string base = R"([scene]
title = "Test"
[particles]
spacing = 8
rest_density = 1
[domain]
min = [0, 0]
max = [400, 600]
[fluid]
gravity = [0, -9.81]
[[fluid.rect]]
min = ["3h", "3h"]
max = [200, 264]
[pressure]
method = "iisph"
[pressure.ssph]
stiffness = 7e5
dt = 0.01
[pressure.iisph]
dt = 0.03
[time]
dt = 0.04
duration = 50
)";

Scene with(const Overrides& overrides) { return parse_scene(base, "t.toml", overrides); }

std::string refusal_of(const Overrides& overrides) {
  try {
    with(overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

const Rect& rect(const Scene& scene, size_t i) { return std::get<Rect>(scene.fluid.at(i).geometry); }

TEST(SceneOverrides, AValueIsToml) {
  EXPECT_EQ(with({"particles.spacing=4"}).spacing, 4);
  EXPECT_EQ(with({"particles.spacing= 4.5 "}).spacing, 4.5);
  EXPECT_EQ(with({"fluid.gravity=[1, 2]"}).gravity, Vec2(1, 2));
  EXPECT_EQ(with({"scene.title=\"A = b\""}).title, "A = b");
  EXPECT_EQ(with({"fluid={gravity=[0,1],rect=[{min=[0,0],count=[2,3]}]}"}).gravity, Vec2(0, 1));
}

TEST(SceneOverrides, AValueThatIsNotTomlIsABareString) {
  EXPECT_EQ(with({"pressure.method=ssph"}).method, PressureMethod::ssph);
  EXPECT_EQ(with({"scene.title=A dam, 3 m = high #2"}).title, "A dam, 3 m = high #2");
  EXPECT_EQ(with({"scene.source="}).source, "");
  EXPECT_EQ(with({"scene.title=1\nvalue2 = 3"}).title, "1\nvalue2 = 3");
  EXPECT_EQ(with({"scene.title=a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r"}).title,
            "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r");
  EXPECT_EQ(
      rect(with({"fluid.rect.0.max=[\"3h\", 264]", "fluid.rect.0.max.0=3h+1", "fluid.rect.0.max.0=5h"}), 0)
          .count,
      glm::uvec2(2, 30));
}

TEST(SceneOverrides, AbsentTablesAreMade) {
  Scene scene = with({"viscosity.coefficient=3", "viscosity.model=laplacian", "output.fps=10"});
  EXPECT_EQ(scene.viscosity_model, ViscosityModel::laplacian);
  EXPECT_EQ(scene.viscosity, 3);
  EXPECT_EQ(scene.fps, 10);
  scene = with({"boundary.model=mirror", "boundary.disc.0.centre=[300,300]", "boundary.disc.0.radius=2h"});
  ASSERT_EQ(scene.boundary.size(), 1u);
  EXPECT_EQ(std::get<Disc>(scene.boundary[0].geometry).radius, 16);
}

TEST(SceneOverrides, ShapesByIndex) {
  Scene scene = with({"fluid.rect.0.max=[200,\"300+3h\"]"});
  EXPECT_EQ(rect(scene, 0).count, glm::uvec2(22, 38));
  EXPECT_EQ(scene.fluid[0].where, "t.toml:11:1");

  scene = with(
      {"fluid.rect.1.min=[300, 24]", "fluid.rect.1.count=[2, 3]", "fluid.rect.2={min=[350,24],count=[4,5]}"});
  ASSERT_EQ(scene.fluid.size(), 3u);
  EXPECT_EQ(rect(scene, 1).count, glm::uvec2(2, 3));
  EXPECT_EQ(scene.fluid[1].key, "fluid.rect.1");
  EXPECT_EQ(scene.fluid[1].where, "--set fluid.rect.1.min");
  EXPECT_EQ(rect(scene, 2).count, glm::uvec2(4, 5));
  EXPECT_EQ(scene.fluid[2].where, "--set fluid.rect.2");
}

TEST(SceneOverrides, AppendedShapesComeLastInTheirOrderAndReplacedOnesKeepTheirPlace) {
  Scene scene = with({"fluid.disc.0={centre=[300,300],radius=20}", "fluid.rect.1={min=[350,24],count=[4,5]}",
                      "fluid.disc.1={centre=[300,500],radius=20}", "fluid.rect.0={min=[0,0],count=[1,1]}"});
  std::vector<std::string> keys;
  for (const FluidShape& shape : scene.fluid) keys.push_back(shape.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"fluid.rect.0", "fluid.disc.0", "fluid.rect.1", "fluid.disc.1"}));
  EXPECT_EQ(rect(scene, 0).count, glm::uvec2(1, 1));
}

TEST(SceneOverrides, TheLastWins) {
  EXPECT_EQ(with({"particles.spacing=4", "particles.spacing=5"}).spacing, 5);
  EXPECT_EQ(with({"particles.spacing=-4", "particles.spacing=5"}).spacing, 5)
      << "checked when all are applied";
}

TEST(SceneOverrides, SettingTheTimeStepRemovesEveryMethodsOwn) {
  EXPECT_EQ(with({}).dt, 0.03);
  EXPECT_EQ(with({"pressure.method=ssph"}).dt, 0.01);
  EXPECT_EQ(with({"time.dt=0.02"}).dt, 0.02);
  for (const Overrides& order : {Overrides{"pressure.method=ssph", "time.dt=0.02", "pressure.ssph.dt=0.5"},
                                 Overrides{"pressure.ssph.dt=0.5", "time.dt=0.02", "pressure.method=ssph"}}) {
    Scene scene = with(order);
    EXPECT_EQ(scene.dt, 0.02);
    EXPECT_FALSE(settings_of(scene)["pressure"]["ssph"].contains("dt"));
    EXPECT_FALSE(settings_of(scene)["pressure"]["iisph"].contains("dt"));
  }
  EXPECT_EQ(with({"time={dt=0.02, duration=1}"}).dt, 0.02);
  EXPECT_EQ(with({"time.duration=1"}).dt, 0.03) << "only time.dt does that";
}

TEST(SceneOverrides, OfTimeStepAndCflTheLaterWins) {
  for (const Overrides& order :
       {Overrides{"time.cfl=0.4", "time.dt_min=1e-3", "time.dt_max=1"},
        Overrides{"time.dt_max=1", "time.dt_min=1e-3", "time.dt=0.02", "time.cfl=0.4"}}) {
    const Scene scene = with(order);
    ASSERT_TRUE(scene.adaptive);
    EXPECT_EQ(scene.adaptive->cfl, 0.4);
    EXPECT_EQ(scene.adaptive->dt_min, 1e-3);
    EXPECT_EQ(scene.adaptive->dt_max, 1);
    EXPECT_FALSE(settings_of(scene)["time"].contains("dt"));
    EXPECT_EQ(settings_of(scene)["time"]["cfl"], 0.4);
  }
  EXPECT_FALSE(with({}).adaptive);
  for (const Overrides& order :
       {Overrides{"time.cfl=0.4", "time.dt_min=1e-3", "time.dt_max=1", "time.dt=0.02"},
        Overrides{"time.cfl=0.4", "time.dt=0.02", "time.dt_min=1e-3", "time.dt_max=1"}}) {
    EXPECT_EQ(with(order).dt, 0.02);
    EXPECT_FALSE(with(order).adaptive);
  }
  EXPECT_EQ(refusal_of({"time={cfl=0.4, dt=0.1, duration=1}"}),
            "--set time: time.cfl: found 0.4 together with time.dt, expected one of the two");
}

TEST(SceneOverrides, MistakesNameTheOverride) {
  const std::vector<std::pair<Overrides, std::string>> cases{
      {{"particles.spacing=-8"},
       "--set particles.spacing: particles.spacing: found -8, expected a number greater than 0"},
      {{"particles.spacing=8", "particles={spacing=-8,rest_density=1}"},
       "--set particles: particles.spacing: found -8, expected a number greater than 0"},
      {{"particles.spacng=8"},
       "--set particles.spacng: particles.spacng: found an unknown key, expected one of the known keys; did "
       "you mean "
       "\"spacing\"?"},
      {{"fluid.rect.0.max.1=\"240+3\""},
       "--set fluid.rect.0.max.1: fluid.rect.0.max.1: found \"240+3\", expected a length (a number, \"a\", "
       "\"bh\", "
       "\"a+bh\" or \"a-bh\", with h the spacing)"},
      {{"fluid.rect.1.min=[0,0]"},
       "--set fluid.rect.1.min: fluid.rect.1.max: found nothing, expected an array of two lengths, or count "
       "in its "
       "place"},
      {{"fluid.rect.0.count=[3,3]"},
       "--set fluid.rect.0.count: fluid.rect.0.count: found an array of 2 together with max, expected one of "
       "the two"},
      {{"fluid.rect=[]"},
       "--set fluid.rect: fluid: found no fluid, expected at least one shape, such as [[fluid.rect]]"},
      {{"pressure.method=wcsph"},
       "--set pressure.method: pressure.wcsph: found nothing, expected a table [pressure.wcsph], as "
       "pressure.method is \"wcsph\""},
      {{"pressure={method=\"ssph\"}"},
       "--set pressure: pressure.ssph: found nothing, expected a table [pressure.ssph], as pressure.method "
       "is "
       "\"ssph\""},
      {{"scene=3"}, "--set scene: scene: found 3, expected a table [scene]"},
      {{"scene.title=\xff"}, "--set scene.title: found text that is not UTF-8, expected KEY=VALUE in UTF-8"},
  };
  for (const auto& [overrides, message] : cases) EXPECT_EQ(refusal_of(overrides), message);
}

TEST(SceneOverrides, MistakesThatAnOverrideCausesElsewhereNameItToo) {
  EXPECT_EQ(refusal_of({"particles.spacing=1000"}),
            "--set particles.spacing: fluid.rect.0.max: found (200, 264), expected more than min (3000, "
            "3000) both ways");
  EXPECT_EQ(refusal_of({"particles.spacing=1e-9"}),
            "--set particles.spacing: particles.spacing: found 1e-09, which makes 5.28e+22 samples up to "
            "fluid.rect.0, expected at most 4294967295 in all shapes together; use a larger spacing or "
            "smaller shapes");
  EXPECT_EQ(refusal_of({"fluid.rect.0.min=[300, 0]"}),
            "--set fluid.rect.0.min: fluid.rect.0.max: found (200, 264), expected more than min (300, 0) "
            "both ways");
  EXPECT_EQ(refusal_of({"pressure.iisph.max_iterations=1"}),
            "--set pressure.iisph.max_iterations: pressure.iisph.max_iterations: found 1, expected at least "
            "min_iterations, which is 2");
}

TEST(SceneOverrides, KeysThatLeadNowhere) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"nonsense", "--set nonsense: found no KEY=VALUE, expected one such as time.dt=0.01"},
      {"=3", "--set =3: found no KEY=VALUE, expected one such as time.dt=0.01"},
      {"time..dt=3",
       "--set time..dt: time..dt: found no such key, expected names and indices with points between them"},
      {"time.=3",
       "--set time.: time.: found no such key, expected names and indices with points between them"},
      {"a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=3",
       "--set a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a: a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a: found no such key, "
       "expected names "
       "and indices with points between them"},
      {"time.dt.x=3", "--set time.dt.x: time.dt: found 0.04, expected a table"},
      {"fluid.rect.2.max=[9,9]",
       "--set fluid.rect.2.max: fluid.rect: found index \"2\", expected 0 to 1, where 1 appends"},
      {"fluid.rect.99999999999999999999.max=[9,9]",
       "--set fluid.rect.99999999999999999999.max: fluid.rect: found index \"99999999999999999999\", "
       "expected 0 to 1, "
       "where 1 appends"},
      {"fluid.disc.1.radius=3",
       "--set fluid.disc.1.radius: fluid.disc: found index \"1\", expected 0, which appends"},
      {"fluid.rect.max=[9,9]",
       "--set fluid.rect.max: fluid.rect: found index \"max\", expected 0 to 1, where 1 appends"},
      {"domain.0=3",
       "--set domain.0: domain.0: found an unknown key, expected one of the known keys; did you mean "
       "\"min\"?"},
      {"output.0=3", "--set output.0: output: found an array of 1, expected a table [output]"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(refusal_of({text}), message);
}

}  // namespace
}  // namespace sluice
