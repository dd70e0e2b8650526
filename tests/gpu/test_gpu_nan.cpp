// A NaN comes out of every stage that it goes into: a maximum or a clamp in a shader may hide it, and a run
// that hides it goes on with nonsense.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

constexpr uint32_t poisoned = 77;

/// A run that stands after its third step, so that every field of the GPU holds something.
struct Stopped {
  Scene scene;
  Samples samples = sample(scene);
  gpu::Context context{};
  std::unique_ptr<gpu::GpuBackend> gpu = gpu::make_backend(context);
  Simulator simulator{scene, samples, *gpu};

  explicit Stopped(const std::string& method)
      : scene(shipped("breaking_dam", {"pressure.method=" + method})) {
    for (int step = 0; step < 3; ++step) simulator.step();
  }

  std::vector<double> values(Field field) const {
    const uint64_t count = info(field).length == Length::totals ? total_count : samples.fluid.size();
    std::vector<double> all(count * element_bytes(info(field).type, 4) / 4);
    gpu->download(field, all);
    return all;
  }

  void poison(Field field) {
    std::vector<double> all = values(field);
    const size_t components = all.size() / samples.fluid.size();
    all[poisoned * components] = std::nan("");
    gpu->upload(field, all);
  }

  double total(Total which) const { return values(Field::totals)[static_cast<uint32_t>(which)]; }
};

TEST(GpuNaN, StaysInThePressureOfTheStateEquation) {
  Stopped stopped("ssph");
  stopped.poison(Field::rho);
  stopped.gpu->run(Stage::state_equation);
  EXPECT_TRUE(std::isnan(stopped.values(Field::p)[poisoned]));
  EXPECT_TRUE(std::isnan(stopped.values(Field::q)[poisoned]));
  EXPECT_FALSE(std::isnan(stopped.values(Field::p)[poisoned + 1]));
}

TEST(GpuNaN, StaysInThePressureOfASweepAndEndsTheSolve) {
  Stopped stopped("iisph");
  stopped.poison(Field::s);
  stopped.gpu->upload(Field::sweeps, std::array<uint32_t, 2>{5, 0});
  stopped.gpu->upload(Field::solve,
                      std::array<double, 4>{1, std::nan(""), 0.5, 1});  // no iterate to go back to
  stopped.gpu->run(Stage::residual);
  stopped.gpu->run(Stage::stop_test);
  stopped.gpu->run(Stage::pressure_update);
  EXPECT_TRUE(std::isnan(stopped.values(Field::q)[poisoned]));
  EXPECT_FALSE(std::isnan(stopped.values(Field::q)[poisoned + 1]));
  std::array<double, 4> solve{};
  stopped.gpu->download(Field::solve, solve);
  EXPECT_TRUE(std::isnan(solve[0]));
  std::array<uint32_t, 2> sweeps{};
  stopped.gpu->download(Field::sweeps, sweeps);
  EXPECT_EQ(sweeps[0], 6u);
  EXPECT_EQ(static_cast<Solve>(sweeps[1]), Solve::capped);
}

TEST(GpuNaN, ShowsInTheTotals) {
  for (const auto& [field, sum, largest] :
       {std::tuple(Field::rho, Total::compression, Total::max_compression),
        std::tuple(Field::v_in, Total::speed_squared, Total::max_speed_squared)}) {
    Stopped stopped("iisph");
    stopped.poison(field);
    stopped.gpu->run(Stage::diagnostics);
    stopped.gpu->run(Stage::totals);
    EXPECT_TRUE(std::isnan(stopped.total(sum))) << info(field).name;
    EXPECT_TRUE(std::isnan(stopped.total(largest))) << info(field).name;
    EXPECT_FALSE(std::isnan(stopped.total(Total::x))) << info(field).name;
  }
}

TEST(GpuNaN, InAPositionGoesToTheFirstCellAndDoesNotSpread) {
  Stopped stopped("iisph");
  stopped.poison(Field::x_in);
  const StepReport report = stopped.simulator.step();
  EXPECT_FALSE(report.diagnostics.finite());
  ASSERT_TRUE(stopped.simulator.failure());
  EXPECT_NE(stopped.simulator.failure()->reason.find("not finite"), std::string::npos)
      << stopped.simulator.failure()->reason;
}

}  // namespace
}  // namespace sluice::test
