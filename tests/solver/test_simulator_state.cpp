// A simulator that goes on from the state of another makes the same steps, to the last bit, whatever the
// models and wherever it runs.
#include <gtest/gtest.h>

#include <ostream>

#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

enum class Place { cpu_float, cpu_double, gpu };

struct Case {
  std::string name, scene;
  std::vector<std::string> overrides;
};

void PrintTo(const Case& value, std::ostream* out) { *out << value.name; }

const std::vector<Case> cases{
    {"jacobi", "breaking_dam", {}},
    {"jittered", "breaking_dam", {"fluid.jitter=0.2", "fluid.seed=3", "fluid.relax=2"}},
    {"barzilai_borwein",
     "breaking_dam",
     {"pressure.iisph.solver=barzilai-borwein", "pressure.iisph.wall=symmetric",
      "pressure.iisph.warm_start=1", "pressure.iisph.stop=residual"}},
    {"ssph", "breaking_dam", {"pressure.method=ssph"}},
    {"wcsph_xsph_akinci", "wcsph_box", {}},
    {"iisph_akinci", "iisph_box", {}},
    {"adaptive", "breaking_dam", {"time.cfl=0.02", "time.dt_min=1e-3", "time.dt_max=0.1"}},
};

/// A scene, a place to run it, and what the places need.
struct Runner {
  Scene scene;
  Samples samples;
  std::unique_ptr<gpu::Context> context;
  std::unique_ptr<Backend> backend;

  Runner(const Case& what, Place place) : scene(shipped(what.scene, what.overrides)), samples(sample(scene)) {
    if (place == Place::gpu) {
      context = std::make_unique<gpu::Context>(std::nullopt, gpu::ShaderLibrary());
      backend = gpu::make_backend(*context);
    } else {
      backend = cpu::make_backend(place == Place::cpu_double ? Precision::double_ : Precision::single_, 1);
    }
  }
};

void expect_equal(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(a.x == b.x);
  EXPECT_TRUE(a.v == b.v);
  EXPECT_TRUE(a.density == b.density);
  EXPECT_TRUE(a.pressure == b.pressure);
}

void expect_equal(const StepReport& a, const StepReport& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.dt, b.dt);
  EXPECT_EQ(a.repeats, b.repeats);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.diagnostics.kinetic_energy, b.diagnostics.kinetic_energy);
  EXPECT_EQ(a.diagnostics.centre_of_mass, b.diagnostics.centre_of_mass);
  EXPECT_EQ(a.diagnostics.wall_force, b.diagnostics.wall_force);
}

/// `steps` more steps of both are the same.
void expect_same_steps(Simulator& one, Simulator& other, uint64_t steps) {
  for (uint64_t step = 0; step < steps; ++step) {
    expect_equal(one.step(), other.step());
    expect_equal(one.snapshot(), other.snapshot());
  }
}

class StateToGoOnFrom : public testing::TestWithParam<std::tuple<Case, Place>> {};

TEST_P(StateToGoOnFrom, LeadsToTheSameSteps) {
  const auto& [what, place] = GetParam();
  Runner first(what, place), second(what, place);
  Simulator whole(first.scene, first.samples, *first.backend);
  for (int step = 0; step < 7; ++step) whole.step();
  Simulator resumed(second.scene, second.samples, *second.backend, whole.state());
  EXPECT_EQ(resumed.time(), whole.time());
  expect_equal(resumed.snapshot(), whole.snapshot());
  // A step that can't be made reports what the last one did.
  EXPECT_GT(whole.state().diagnostics.kinetic_energy, 0);
  EXPECT_EQ(resumed.state().diagnostics.kinetic_energy, whole.state().diagnostics.kinetic_energy);
  EXPECT_EQ(resumed.state().diagnostics.wall_force, whole.state().diagnostics.wall_force);
  expect_same_steps(whole, resumed, 6);
}

std::string state_name(const testing::TestParamInfo<StateToGoOnFrom::ParamType>& info) {
  const Place place = std::get<Place>(info.param);
  return std::get<Case>(info.param).name + (place == Place::gpu          ? "_gpu"
                                            : place == Place::cpu_double ? "_cpu_double"
                                                                         : "_cpu_float");
}
INSTANTIATE_TEST_SUITE_P(All, StateToGoOnFrom,
                         testing::Combine(testing::ValuesIn(cases),
                                          testing::Values(Place::cpu_float, Place::cpu_double, Place::gpu)),
                         state_name);

// llvmpipe's bits are those of the processor; a graphics card's need not be.
TEST(SimulatorState, GoesFromOneBackendToTheOther) {
  Runner on_gpu(cases[1], Place::gpu), on_cpu(cases[1], Place::cpu_float);
  if (!on_gpu.context->software()) GTEST_SKIP() << "not a software OpenGL";
  Simulator gpu(on_gpu.scene, on_gpu.samples, *on_gpu.backend);
  for (int step = 0; step < 5; ++step) gpu.step();
  Simulator cpu(on_cpu.scene, on_cpu.samples, *on_cpu.backend, gpu.state());
  expect_same_steps(gpu, cpu, 3);
  Runner back(cases[1], Place::gpu);
  Simulator again(back.scene, back.samples, *back.backend, cpu.state());
  expect_same_steps(cpu, again, 3);
}

TEST(SimulatorState, OfTheStartIsTheStart) {
  Runner first(cases[1], Place::cpu_double), second(cases[1], Place::cpu_double);
  Simulator whole(first.scene, first.samples, *first.backend);
  Simulator resumed(second.scene, second.samples, *second.backend, whole.state());
  EXPECT_EQ(resumed.steps(), 0u);
  expect_equal(resumed.snapshot(), whole.snapshot());
  EXPECT_NE(whole.snapshot().x, first.samples.fluid) << "it was relaxed, and that is not done again";
  expect_same_steps(whole, resumed, 4);
}

TEST(SimulatorState, KeepsATimeStepThatWasChanged) {
  Runner first(cases[0], Place::cpu_double), second(cases[0], Place::cpu_double);
  Simulator whole(first.scene, first.samples, *first.backend);
  whole.step();
  whole.change_dt(0.013);
  for (int step = 0; step < 4; ++step) whole.step();
  Simulator resumed(second.scene, second.samples, *second.backend, whole.state());
  EXPECT_EQ(resumed.dt(), 0.013);
  EXPECT_EQ(resumed.time(), whole.time());
  expect_same_steps(whole, resumed, 4);
}

// After a step that failed, what it started from must be there.
TEST(SimulatorState, AFailureInTheFirstStepIsFoundAsInTheWholeRun) {
  const Case bad{"bad", "breaking_dam", {"pressure.method=ssph", "pressure.ssph.stiffness=1e9"}};
  Runner first(bad, Place::cpu_double), second(bad, Place::cpu_double);
  Simulator whole(first.scene, first.samples, *first.backend);
  SimulationState last;
  while (!whole.failure()) {
    last = whole.state();
    whole.step();
  }
  Simulator resumed(second.scene, second.samples, *second.backend, last);
  resumed.step();
  ASSERT_TRUE(resumed.failure());
  EXPECT_EQ(resumed.failure()->reason, whole.failure()->reason);
  EXPECT_EQ(resumed.failure()->id, whole.failure()->id);
  EXPECT_EQ(resumed.failure()->x, whole.failure()->x);
  expect_equal(resumed.snapshot(), whole.snapshot());
}

}  // namespace
}  // namespace sluice::test
