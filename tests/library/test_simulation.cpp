// The library's Simulation: what it owns, its fields by name, what can be set, where runs end.
#include <gtest/gtest.h>

#include <numbers>

#include "core/solver/simulator.hpp"
#include "sluice/cpu.hpp"
#include "sluice/load.hpp"
#include "sluice/simulation.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

// Nothing that is kept can be a temporary.
static_assert(!std::is_constructible_v<Simulator, Scene, Samples&, Backend&>);
static_assert(!std::is_constructible_v<Simulator, Scene&, Samples, Backend&>);
static_assert(std::is_constructible_v<Simulator, Scene&, Samples&, Backend&>);
static_assert(std::is_same_v<decltype(std::declval<Plan>()[Phase::sweep]), std::vector<Stage>>);
static_assert(std::is_same_v<decltype(std::declval<sluice::Simulation>().scene()), Scene>);

Scene dam(std::initializer_list<std::string> overrides = {}) { return load_scene("breaking_dam", overrides); }

sluice::Simulation dam_on_cpu(Precision precision = Precision::single_,
                              std::initializer_list<std::string> overrides = {}) {
  return sluice::Simulation(dam(overrides), cpu::device({.precision = precision, .threads = 2}));
}

std::vector<double> doubles(const sluice::Simulation& simulation, std::string_view name) {
  const auto values = simulation.field(name).as<double>();
  return {values.begin(), values.end()};
}

TEST(LibrarySimulation, HasTheBitsOfTheSimulatorAndOwnsAllItNeeds) {
  test::Simulation reference(dam(), Precision::single_, 1);
  sluice::Simulation made = dam_on_cpu();
  made.step();
  sluice::Simulation moved = std::move(made);
  moved.step();
  for (int k = 0; k < 2; ++k) reference.simulator->step();
  const Snapshot a = reference.simulator->snapshot(), b = moved.snapshot();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(moved.steps(), 2u);
}

TEST(LibrarySimulation, FieldsAreInTheOrderOfIds) {
  sluice::Simulation simulation = dam_on_cpu();
  for (int k = 0; k < 40; ++k) simulation.step();
  const Snapshot state = simulation.snapshot();
  const auto x = doubles(simulation, "position"), rho = doubles(simulation, "rho"),
             p = doubles(simulation, "p");
  for (size_t i = 0; i < state.x.size(); ++i) {
    ASSERT_EQ(Vec2(x[2 * i], x[2 * i + 1]), state.x[i]);
    ASSERT_EQ(rho[i], state.density[i]);
    ASSERT_EQ(p[i], state.pressure[i]);
  }
  const auto before = doubles(simulation, "pressure");
  simulation.step();
  EXPECT_EQ(doubles(simulation, "p_in"), before);
  EXPECT_NE(doubles(simulation, "p"), before);
}

TEST(LibrarySimulation, EveryFieldThatIsListedCanBeReadAndSaysItsShape) {
  sluice::Simulation simulation = dam_on_cpu();
  simulation.step();
  for (const FieldDescription& each : simulation.fields()) {
    SCOPED_TRACE(each.name);
    EXPECT_FALSE(each.meaning.empty());
    const FieldView view = simulation.field(each.name);
    const size_t number = view.type == NumberType::float64 ? 8 : 4;
    EXPECT_EQ(view.bytes.size(), view.rows * view.columns * number);
    EXPECT_GT(view.rows, 0u);
  }
}

TEST(LibrarySimulation, FieldsInMemoryAreTheMemory) {
  sluice::Simulation simulation = dam_on_cpu();
  simulation.step();
  const FieldView rho = simulation.field_in_memory("rho");
  EXPECT_TRUE(rho.in_place);
  EXPECT_EQ(rho.as<float>().data(), simulation.field_in_memory("rho").as<float>().data());
  EXPECT_FALSE(simulation.field_in_memory("index").in_place);
  const auto id = simulation.field_in_memory("id").as<uint32_t>();
  const auto by_id = doubles(simulation, "rho");
  for (size_t i = 0; i < id.size(); ++i) ASSERT_EQ(double(rho.as<float>()[i]), by_id[id[i]]);
}

TEST(LibrarySimulation, NamesAndTypesThatAreWrongAreRefused) {
  const sluice::Simulation simulation = dam_on_cpu();
  EXPECT_THROW(simulation.field("colour"), InputError);
  EXPECT_THROW(simulation.field_in_memory("position"), InputError);
  EXPECT_THROW(simulation.field("wall_viscosity_"), InputError);
  EXPECT_THROW(simulation.field("density").as<float>(), InputError);
  EXPECT_THROW(cpu::device({.threads = -1}), InputError);
}

TEST(LibrarySimulation, VelocitiesThatAreSetAreThose) {
  sluice::Simulation simulation = dam_on_cpu(Precision::double_);
  simulation.step();
  std::vector<Vec2> v = simulation.snapshot().v;
  const std::vector<Vec2> x = simulation.snapshot().x;
  for (size_t i = 0; i < v.size(); ++i) v[i] += Vec2(double(i), std::numbers::pi);
  simulation.set_velocities(v);
  EXPECT_EQ(simulation.snapshot().v, v);
  EXPECT_EQ(simulation.snapshot().x, x);
}

// Stages count positions from the domain's corner, and people from the scene's origin.
TEST(LibrarySimulation, PositionsCountFromTheScenesOrigin) {
  sluice::Simulation simulation = dam_on_cpu(Precision::double_, {"domain.min=[-80, -16]"});
  simulation.step();
  const Snapshot before = simulation.snapshot();
  const auto x = doubles(simulation, "position");
  for (size_t i = 0; i < before.x.size(); ++i) ASSERT_EQ(Vec2(x[2 * i], x[2 * i + 1]), before.x[i]);
  std::vector<Vec2> moved = before.x;
  for (Vec2& each : moved) each.x += 1;
  simulation.set_positions(moved);
  for (size_t i = 0; i < moved.size(); ++i)
    ASSERT_NEAR(glm::length(simulation.snapshot().x[i] - moved[i]), 0, 1e-12);
  EXPECT_EQ(simulation.snapshot().v, before.v);
}

TEST(LibrarySimulation, AfterAFailureFieldsAreThoseOfTheSnapshot) {
  sluice::Simulation simulation = dam_on_cpu(Precision::single_, {"viscosity.coefficient=1e30"});
  simulation.run(40);
  ASSERT_TRUE(simulation.failure());
  const Snapshot state = simulation.snapshot();
  EXPECT_EQ(doubles(simulation, "density"), state.density);
  const auto x = doubles(simulation, "position"), v = doubles(simulation, "velocity");
  for (size_t i = 0; i < state.x.size(); ++i) {
    ASSERT_EQ(Vec2(x[2 * i], x[2 * i + 1]), state.x[i]);
    ASSERT_EQ(Vec2(v[2 * i], v[2 * i + 1]), state.v[i]);
  }
}

TEST(LibrarySimulation, MeasuresAreOfTheStateNow) {
  sluice::Simulation simulation(
      load_scene("breaking_dam", {R"(probe=[{name="front",y=30}])", "boundary.container.0.name=box"}),
      cpu::device());
  const auto front = [&] { return simulation.probes().at(0).second.value(); };
  simulation.run(1);
  const double before = front();
  const double pressure = simulation.values_at({40, 40}).pressure;
  EXPECT_EQ(simulation.wall_forces().at(0).first, "box");
  simulation.run(4);
  EXPECT_GT(front(), before + 20);
  EXPECT_NE(simulation.values_at({40, 40}).pressure, pressure);
}

TEST(LibrarySimulation, WhatCannotBeSetChangesNothing) {
  sluice::Simulation simulation = dam_on_cpu();
  simulation.step();
  const Snapshot before = simulation.snapshot();
  std::vector<Vec2> too_few(before.x.begin(), before.x.end() - 1), not_finite = before.x, too_far = before.x;
  not_finite.back().y = std::numeric_limits<double>::quiet_NaN();
  too_far.back().x = 1e39;
  for (const auto& values : {too_few, not_finite, too_far}) {
    EXPECT_THROW(simulation.set_positions(values), InputError);
    EXPECT_THROW(simulation.set_velocities(values), InputError);
  }
  EXPECT_EQ(simulation.snapshot().x, before.x);
  EXPECT_EQ(simulation.snapshot().v, before.v);
}

TEST(LibrarySimulation, AfterAFailureThereIsNoStepAndNoCheckpoint) {
  const TemporaryFolder folder;
  sluice::Simulation simulation = dam_on_cpu(Precision::single_, {"time.dt=5"});
  simulation.run(1000);
  ASSERT_TRUE(simulation.failure());
  EXPECT_LT(simulation.steps(), 200u);
  EXPECT_THROW(simulation.step(), InputError);
  EXPECT_THROW(simulation.write_checkpoint(folder / "none"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(LibrarySimulation, RunsEndAtTheTime) {
  sluice::Simulation fixed = dam_on_cpu();
  fixed.run(0.3);
  EXPECT_EQ(fixed.steps(), 8u);  // 0.3 / 0.04 = 7.5, rounded as by `sluice run`
  fixed.run(0.3);
  EXPECT_EQ(fixed.steps(), 8u);
  sluice::Simulation adaptive =
      dam_on_cpu(Precision::single_, {"time.cfl=0.4", "time.dt_min=1e-4", "time.dt_max=0.07"});
  adaptive.run(0.3);
  EXPECT_DOUBLE_EQ(adaptive.time(), 0.3);
  EXPECT_THROW(adaptive.step(0.2), InputError);
  int seen = 0;
  fixed.run(1, [&](const StepReport&) { return ++seen < 3; });
  EXPECT_EQ(seen, 3);
}

TEST(LibrarySimulation, SummaryStateAndWarningsAreTheProgramsOwn) {
  const TemporaryFolder folder;
  sluice::Simulation simulation = dam_on_cpu();
  simulation.run(0.4);
  EXPECT_NE(simulation.summary().find("\"steps\": 10"), std::string::npos);
  simulation.write_state(folder / "state.csv");
  EXPECT_GT(std::filesystem::file_size(folder / "state.csv"), 1000u);
  EXPECT_TRUE(simulation.warnings().empty());
  EXPECT_FALSE(dam_on_cpu(Precision::single_, {"viscosity.coefficient=1e6"}).warnings().empty());
}

TEST(LoadScene, ChangedHasMoreOverridesAfterItsOwn) {
  const Scene scene = load_scene("breaking_dam", {"time.dt=0.02", "fluid.seed=5"});
  const Scene other = changed(scene, {"time.dt=0.01"});
  EXPECT_EQ(other.dt, 0.01);
  EXPECT_EQ(other.seed, 5u);
  EXPECT_EQ(other.record.overrides.size(), 3u);
  EXPECT_THROW(changed(scene, {"time.dtt=1"}), InputError);
}

}  // namespace
}  // namespace sluice::test
