// Fluid that collapses into one place ends the run, with the place and a particle, and takes no memory beyond
// its share; on both backends in the same step. Strays crowd into the outermost cells and do no harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "gpu/context.hpp"
#include "sluice/error.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/growing.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// A block without walls and hardly any pressure, all of which heads for its middle.
Scene imploding() {
  return shipped(
      "breaking_dam",
      {"pressure.method=ssph", "pressure.ssph.stiffness=1e-9", "fluid.gravity=[0,0]", "boundary.container=[]",
       "viscosity.coefficient=0",
       "fluid.rect=[{min=[24,24],count=[40,50],velocity_gradient=[[-5,0],[0,-5]]}]", "time.dt=0.01"});
}

struct Collapse {
  Failure failure;
  Snapshot state;
  StepReport last;
  uint64_t largest_list = 0;
};

Collapse collapse_on(Backend& backend) {
  const Scene scene = imploding();
  const Samples samples = sample(scene);
  Growing growing(backend);
  Simulator simulator(scene, samples, growing);
  StepReport last;
  while (!simulator.failure() && simulator.steps() < 40) last = simulator.step();
  EXPECT_TRUE(simulator.failure());
  return {simulator.failure().value_or(Failure{}), simulator.snapshot(), last, growing.largest};
}

TEST(Crowd, ACollapseEndsTheRunAndIsDiagnosed) {
  const Collapse found = collapse_on(*cpu::make_backend(Precision::double_, 1));
  EXPECT_GT(found.failure.step, 10u);
  EXPECT_LT(found.failure.step, 22u) << "they meet in step 20";
  EXPECT_NE(
      found.failure.reason.find("particles crowd together in a cell of the grid, where about 4 have room"),
      std::string::npos)
      << found.failure.reason;
  EXPECT_EQ(found.failure.step, found.last.step);
  EXPECT_EQ(found.failure.time, found.last.time);
  EXPECT_EQ(found.state.step, found.failure.step - 1) << "the state is the last one that a step was made of";
  EXPECT_EQ(found.failure.x, found.state.x[found.failure.id]);
  // No cell is fuller than that of the particle.
  const Params params = make_params(imploding(), 2000);
  std::map<uint32_t, uint32_t> members;
  for (const Vec2 x : found.state.x) ++members[cell_of(params, x)];
  uint32_t most = 0;
  for (const auto& [cell, count] : members) most = std::max(most, count);
  EXPECT_EQ(members[cell_of(params, found.failure.x)], most);
  EXPECT_TRUE(found.failure.reason.starts_with(std::to_string(most)));
  EXPECT_TRUE(found.last.diagnostics.finite());
  EXPECT_LE(found.largest_list, most_list_growth * first_list_size(2000, 1));
}

TEST(Crowd, BothBackendsEndAlike) {
  if (!gpu::Context().software()) GTEST_SKIP() << "runs are equal on llvmpipe only";
  Gpu gpu;
  const Collapse on_gpu = collapse_on(*gpu.backend);
  const Collapse on_cpu = collapse_on(*cpu::make_backend(Precision::single_, 2));
  EXPECT_EQ(on_gpu.failure.step, on_cpu.failure.step);
  EXPECT_EQ(on_gpu.failure.id, on_cpu.failure.id);
  EXPECT_EQ(on_gpu.failure.reason, on_cpu.failure.reason);
  EXPECT_EQ(on_gpu.state.x, on_cpu.state.x);
  EXPECT_EQ(on_gpu.state.v, on_cpu.state.v);
}

/// Fluid of which one thread has all the neighbours: a dense heap below and a thin spread above.
TEST(Crowd, WhetherThereIsOneDoesNotDependOnThreads) {
  const Scene scene = imploding();
  Samples samples;
  for (uint32_t i = 0; i < 500; ++i) samples.fluid.emplace_back(100 + 0.05 * (i % 25), 40 + 0.05 * (i / 25));
  for (uint32_t i = 0; i < 3500; ++i) samples.fluid.emplace_back(10 + 12.0 * (i % 30), 80 + 12.0 * (i / 30));
  samples.fluid_shape.assign(samples.fluid.size(), 0);
  Scene still = scene;
  still.fluid[0].velocity_gradient = {};
  std::vector<uint64_t> lists;
  std::vector<Vec2> state;
  for (const int threads : {1, 2, 3, 16}) {
    const auto backend = cpu::make_backend(Precision::double_, threads);
    Growing growing(*backend);
    Simulator simulator(still, samples, growing);
    for (int step = 0; step < 2; ++step) simulator.step();
    EXPECT_FALSE(simulator.failure()) << threads << " threads";
    EXPECT_GT(growing.largest, first_list_size(4000, 1)) << "it never grew";
    lists.push_back(growing.largest);
    if (state.empty()) state = simulator.snapshot().x;
    EXPECT_EQ(simulator.snapshot().x, state) << threads << " threads";
  }
  EXPECT_EQ(lists, std::vector<uint64_t>(lists.size(), lists.front()));
}

/// All in one cell, more than a shader could look through, in another order than that of their ids.
TEST(Crowd, ThatIsThereFromTheStartIsRefused) {
  const Scene scene = imploding();
  Samples samples;
  for (uint32_t i = 0; i < most_rounds + 100; ++i)
    samples.fluid.emplace_back(100 + 1e-5 * ((i * 7919) % 65537), 101);
  samples.fluid_shape.assign(samples.fluid.size(), 0);
  Gpu gpu;
  const auto on_cpu = cpu::make_backend(Precision::single_, 2);
  for (Backend* backend : {static_cast<Backend*>(gpu.backend.get()), on_cpu.get()}) {
    const std::string message =
        message_of<InputError>([&] { const Simulator simulator(scene, samples, *backend); });
    EXPECT_NE(message.find("too many particles in one place"), std::string::npos) << message;
  }
}

// As many as may be looked through, though none is in reach of another: strays, clamped into one cell.
TEST(Crowd, StraysInOneCellAreNone) {
  Scene scene = imploding();
  scene.fluid[0].velocity_gradient = {};
  Samples samples = sample(scene);
  constexpr uint32_t strays = 190;  // fewer than a tenth, which would end the run
  for (uint32_t i = 0; i < strays; ++i) samples.fluid[i] = Vec2(-1e5 - 100.0 * i, -8e6 - 50.0 * (i % 7));
  Gpu gpu;
  const auto on_cpu = cpu::make_backend(Precision::single_, 2);
  std::vector<Snapshot> states;
  for (Backend* backend : {static_cast<Backend*>(gpu.backend.get()), on_cpu.get()}) {
    Growing growing(*backend);
    Simulator simulator(scene, samples, growing);
    StepReport report;
    for (int step = 0; step < 3; ++step) report = simulator.step();
    EXPECT_FALSE(simulator.failure());
    EXPECT_EQ(report.diagnostics.lost, strays);
    EXPECT_EQ(growing.largest, 0u) << "the list grew for strays";
    states.push_back(simulator.snapshot());
  }
  if (gpu::Context().software()) {
    EXPECT_EQ(states[0].x, states[1].x);
  }
}

}  // namespace
}  // namespace sluice::test
