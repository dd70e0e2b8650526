// What the keys of `sluice play` choose: spacing, time step and method of a scene.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/sluice/play/choice.hpp"
#include "core/scene/settings.hpp"
#include "sluice/error.hpp"
#include "sluice/load.hpp"
#include "sluice/sampling.hpp"

namespace sluice::test {
namespace {

app::Choice choice_of(const std::string& scene, double refinement = 1, double dt_factor = 1) {
  return {scene, {}, std::nullopt, refinement, dt_factor};
}

TEST(PlayChoice, WithoutAChangeItIsTheScene) {
  EXPECT_EQ(settings_of(app::load_choice(choice_of("breaking_dam"))),
            settings_of(load_scene("breaking_dam")));
}

TEST(PlayChoice, TheTimeStepFollowsTheSpacing) {
  const Scene scene = app::load_choice(choice_of("breaking_dam", 1.25, 0.8));
  EXPECT_EQ(scene.spacing, 10);
  EXPECT_DOUBLE_EQ(scene.dt, 0.04);
}

TEST(PlayChoice, AFinerOneStaysBelowTheViscousLimit) {
  const Scene half = app::load_choice(choice_of("breaking_dam", 0.5)),
              quarter = app::load_choice(choice_of("breaking_dam", 0.25));
  EXPECT_DOUBLE_EQ(half.dt, 0.02);  // 200 0.02/16 = 0.25
  EXPECT_DOUBLE_EQ(quarter.viscosity * quarter.dt / (quarter.spacing * quarter.spacing), 0.4);
  EXPECT_DOUBLE_EQ(app::load_choice(choice_of("breaking_dam", 0.25, 0.5)).dt, quarter.dt / 2);
}

TEST(PlayChoice, CountedLatticesKeepTheirSize) {
  const Scene scene = app::load_choice(choice_of("wcsph_box", 0.5));
  EXPECT_EQ(std::get<Rect>(scene.fluid[0].geometry).count, glm::uvec2(80, 60));
  EXPECT_EQ(sample(scene).fluid.size(), 4800u);
  EXPECT_DOUBLE_EQ(scene.dt, 0.001);
}

TEST(PlayChoice, AMethodComesWithItsOwnTimeStep) {
  app::Choice start = choice_of("breaking_dam", 1, 0.8);
  start.overrides = {"time.dt=0.03", "fluid.jitter=0.1"};
  const app::Choice ssph = app::with_method(start, PressureMethod::ssph, app::load_choice(start));
  const Scene scene = app::load_choice(ssph);
  EXPECT_EQ(scene.method, PressureMethod::ssph);
  EXPECT_EQ(scene.dt, 0.01);
  EXPECT_EQ(scene.jitter, 0.1);
}

TEST(PlayChoice, AMethodWithoutItsTableIsRefused) {
  const app::Choice start = choice_of(std::string(SLUICE_SOURCE_DIR) + "/tests/data/iisph_only.toml");
  const Scene scene = app::load_choice(start);
  EXPECT_THROW(app::with_method(start, PressureMethod::ssph, scene), InputError);
  EXPECT_THROW(app::with_method(start, PressureMethod::wcsph, scene), InputError);
  EXPECT_NO_THROW(app::with_method(start, PressureMethod::iisph, scene));
}

}  // namespace
}  // namespace sluice::test
