// What must hold whatever the numbers: momentum, symmetries, and that an absent model is one with coefficient
// 0.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/scene/keys.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

Scene blob(const std::string& method, const std::string& extra = "") {
  return parse_scene(R"(
    [scene]
    title = "free blob"
    [particles]
    spacing = 1
    rest_density = 1
    [domain]
    min = [-50, -50]
    max = [50, 50]
    [fluid]
    gravity = [0, 0]
    jitter = 0.3
    seed = 11
    [[fluid.disc]]
    centre = [2, -3]
    radius = 9
    velocity = [0.3, -0.2]
    velocity_gradient = [[-0.05, 0.02], [0.03, -0.04]]
    [pressure.ssph]
    stiffness = 100
    [pressure.wcsph]
    kappa = 100
    [time]
    dt = 0.02
    duration = 1
    [pressure]
    method = ")" + method +
                         "\"\n" + extra,
                     "blob.toml");
}

Vec2 momentum(const Snapshot& snapshot, double m) {
  Vec2 sum{};
  for (const Vec2 v : snapshot.v) sum += m * v;
  return sum;
}

double scale_of(const Snapshot& snapshot, double m) {
  double sum = 0;
  for (const Vec2 v : snapshot.v) sum += m * glm::length(v);
  return sum;
}

TEST(Momentum, FreeBlobWithoutViscosityKeepsIt) {
  for (const char* method : {"iisph", "ssph", "wcsph"}) {
    Simulation simulation(blob(method));
    const Snapshot start = simulation.simulator->snapshot();
    const double m = simulation.scene.mass();
    const auto reports = simulation.run(50);
    const Snapshot end = simulation.simulator->snapshot();
    ASSERT_FALSE(simulation.simulator->failure());
    EXPECT_GT(relative_difference(end.v, start.v), 0.1) << "no pressure acted";
    EXPECT_LT(glm::length(momentum(end, m) - momentum(start, m)), 1e-12 * scale_of(start, m)) << method;
  }
}

// The viscosity's 1/rho_j is not symmetric: the test above would fail with it, so it can see a broken
// symmetry.
TEST(Momentum, LaplacianViscosityChangesItALittle) {
  Simulation simulation(blob("iisph", "[viscosity]\nmodel = \"laplacian\"\ncoefficient = 1\n"));
  const Snapshot start = simulation.simulator->snapshot();
  simulation.run(50);
  const double m = simulation.scene.mass();
  EXPECT_GT(glm::length(momentum(simulation.simulator->snapshot(), m) - momentum(start, m)),
            1e-9 * scale_of(start, m));
}

/// The breaking dam with every position (domain, walls, fluid) mapped.
template <class Map>
Snapshot mapped_dam(Map map, uint64_t steps, std::vector<size_t> order = {}) {
  Simulation base(shipped("breaking_dam", {"fluid.jitter=0.1"}));
  Samples samples = base.samples;
  if (order.empty()) {
    for (size_t i = 0; i < samples.fluid.size(); ++i) order.push_back(i);
  }
  for (size_t i = 0; i < order.size(); ++i) samples.fluid[i] = map(base.samples.fluid[order[i]]);
  for (Vec2& x : samples.boundary) x = map(x);
  Scene scene = base.scene;
  const Vec2 a = map(scene.domain_min), b = map(scene.domain_max);
  scene.domain_min = glm::min(a, b);
  scene.domain_max = glm::max(a, b);
  Simulator simulator(scene, samples, *base.backend);
  for (uint64_t step = 0; step < steps; ++step) simulator.step();
  return simulator.snapshot();
}

constexpr uint64_t few_steps = 20;

TEST(Symmetry, TranslationMovesTheResult) {
  const Vec2 shift(1000, -300);
  const auto plain = mapped_dam([](Vec2 x) { return x; }, few_steps);
  auto moved = mapped_dam([&](Vec2 x) { return x + shift; }, few_steps);
  for (Vec2& x : moved.x) x -= shift;
  EXPECT_LT(relative_difference(moved.x, plain.x), 1e-11);
  EXPECT_LT(relative_difference(moved.v, plain.v), 1e-9);
  EXPECT_LT(relative_difference(moved.density, plain.density), 1e-11);
}

TEST(Symmetry, MirrorImageBehavesLikeTheMirrorImage) {
  const auto plain = mapped_dam([](Vec2 x) { return x; }, few_steps);
  auto mirrored = mapped_dam([](Vec2 x) { return Vec2(400 - x.x, x.y); }, few_steps);
  for (Vec2& x : mirrored.x) x.x = 400 - x.x;
  for (Vec2& v : mirrored.v) v.x = -v.x;
  EXPECT_LT(relative_difference(mirrored.x, plain.x), 1e-11);
  EXPECT_LT(relative_difference(mirrored.v, plain.v), 1e-9);
}

TEST(Symmetry, OrderOfParticlesDoesNotMatter) {
  const auto plain = mapped_dam([](Vec2 x) { return x; }, few_steps);
  std::vector<size_t> order(plain.x.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = (i * 271) % order.size();
  const auto permuted = mapped_dam([](Vec2 x) { return x; }, few_steps, order);
  std::vector<Vec2> x(order.size()), v(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    x[order[i]] = permuted.x[i];
    v[order[i]] = permuted.v[i];
  }
  EXPECT_LT(relative_difference(x, plain.x), 1e-11);
  EXPECT_LT(relative_difference(v, plain.v), 1e-9);
}

/// The state after a few steps, with the plan of other needs than the scene's own.
Snapshot run_few(const Scene& scene) {
  Simulation simulation(scene);
  simulation.run(few_steps);
  return simulation.simulator->snapshot();
}

TEST(Needs, NoViscosityEqualsCoefficientZero) {
  Scene none = shipped("breaking_dam"), zero = none;
  none.viscosity_model = ViscosityModel::none;
  zero.viscosity = 0;
  EXPECT_TRUE(same_bits(run_few(none), run_few(zero)));
  EXPECT_FALSE(same_bits(run_few(none), run_few(shipped("breaking_dam"))));
}

// A coefficient so small that it is 0 in float plans its stages all the same; they change nothing.
TEST(Needs, ACoefficientOfNothingEqualsNone) {
  const auto stages_with = [](const std::string& path, const char* value) {
    return make_plan(model_of(shipped("template", {path + "=" + value}))).stages();
  };
  std::set<std::string> found;
  for (const SceneKey& key : scene_keys()) {
    const std::string path(key.path);
    if (key.type != KeyType::number || key.range.low != 0 || key.range.low_excluded) continue;
    if (path.find('[') != path.npos || stages_with(path, "0") == stages_with(path, "1e-300")) continue;
    found.insert(path);
    bool does_something = false;
    for (const char* method : {"iisph", "ssph", "wcsph"}) {
      SCOPED_TRACE(path + ", " + method);
      const std::string chosen = std::string("pressure.method=") + method;
      const auto run = [&](const char* value) {
        Simulation simulation(shipped("template", {chosen, path + "=" + value}), Precision::single_);
        simulation.run(few_steps);
        return simulation.simulator->snapshot();
      };
      EXPECT_TRUE(same_bits(run("0"), run("1e-300")));
      does_something = does_something || !same_bits(run("0"), run("1"));
    }
    EXPECT_TRUE(does_something) << path;
  }
  EXPECT_TRUE(found.contains("viscosity.coefficient"));
}

// The stage itself, run with coefficient 0, changes nothing: leaving it out is the same.
TEST(Needs, ViscosityStageWithCoefficientZeroAddsNothing) {
  Scene scene = shipped("breaking_dam", {"fluid.jitter=0.1"});
  Simulation simulation(scene);
  simulation.run(few_steps);
  Params params = make_params(scene, static_cast<uint32_t>(simulation.samples.fluid.size()));
  params.nu = 0;
  simulation.backend->configure(params, needs_of(scene));
  std::vector<double> before(2 * simulation.samples.fluid.size()), after(before);
  simulation.backend->run(Stage::external);
  simulation.backend->download(Field::a_n, before);
  simulation.backend->run(Stage::viscosity);
  simulation.backend->download(Field::a_n, after);
  EXPECT_EQ(before, after);
}

TEST(Needs, NoBoundaryEqualsABoundaryOutOfReach) {
  const Scene without = blob("iisph");
  const Scene with = blob("iisph", R"(
    [boundary]
    model = "mirror"
    [[boundary.segment]]
    from = [-40, -40]
    to = [-30, -40]
  )");
  EXPECT_TRUE(needs_of(with).boundary);
  EXPECT_FALSE(needs_of(without).boundary);
  EXPECT_TRUE(same_bits(run_few(without), run_few(with)));
}

TEST(Needs, NoCentralForceEqualsCoefficientZeroAboutAnyCentre) {
  Scene scene = blob("ssph"), other = scene;
  other.centre = {3, 7};
  EXPECT_TRUE(same_bits(run_few(scene), run_few(other)));
}

}  // namespace
}  // namespace sluice::test
