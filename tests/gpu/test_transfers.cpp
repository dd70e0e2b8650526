// What crosses the bus: a step reads back a few numbers and nothing per particle, and looks at the pressure
// solve less than once per sweep without ending it any later.
#include <gtest/gtest.h>

#include <map>

#include "core/agree/agreement.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// Counts transfers by field; sweeps go through as they are.
class Counting final : public ForwardingBackend {
 public:
  explicit Counting(Backend& backend) : ForwardingBackend(backend) {}

  void sweep(const std::vector<Stage>& stages, uint32_t times) override { active_->sweep(stages, times); }
  void upload(Field field, std::span<const double> values) override {
    ++uploads[field];
    ForwardingBackend::upload(field, values);
  }
  void upload(Field field, std::span<const uint32_t> values) override {
    ++uploads[field];
    ForwardingBackend::upload(field, values);
  }
  void download(Field field, std::span<double> values) const override {
    ++downloads[field];
    ForwardingBackend::download(field, values);
  }
  void download(Field field, std::span<uint32_t> values) const override {
    ++downloads[field];
    ForwardingBackend::download(field, values);
  }

  std::map<Field, int> uploads;
  mutable std::map<Field, int> downloads;
};

/// Asks after every sweep, as the CPU does.
class AskingAlways final : public ForwardingBackend {
 public:
  explicit AskingAlways(Backend& backend) : ForwardingBackend(backend) {}
  void sweep(const std::vector<Stage>& stages, uint32_t times) override { Backend::sweep(stages, times); }
};

constexpr int steps = 60;

TEST(Transfers, AStepReadsBackAFewNumbersAndNothingPerParticle) {
  for (const char* method : {"iisph", "ssph", "wcsph"}) {
    const Scene scene = shipped("breaking_dam", {std::string("pressure.method=") + method});
    const Samples samples = sample(scene);
    const gpu::Context context;
    const auto gpu = gpu::make_backend(context);
    Counting counting(*gpu);
    Simulator simulator(scene, samples, counting);
    counting.uploads.clear();
    counting.downloads.clear();
    for (int step = 0; step < steps; ++step) simulator.step();
    for (const auto& [field, count] : counting.downloads) {
      EXPECT_TRUE(info(field).length == Length::one || info(field).length == Length::totals)
          << info(field).name << " came back " << count << " times";
    }
    for (const auto& [field, count] : counting.uploads) EXPECT_EQ(field, Field::sweeps) << info(field).name;
    EXPECT_EQ(counting.downloads[Field::totals], steps);
  }
}

TEST(Transfers, LookingLessOftenEndsNoSolveLater) {
  const Scene scene = shipped("breaking_dam", {"time.dt=0.06"});
  const Samples samples = sample(scene);
  const gpu::Context context;
  const auto first = gpu::make_backend(context), second = gpu::make_backend(context);
  Counting seldom(*first);
  AskingAlways always(*second);
  Simulator a(scene, samples, seldom), b(scene, samples, always);
  seldom.downloads.clear();
  uint64_t sweeps = 0, changes = 0;
  uint32_t last = 0;
  for (int step = 0; step < steps; ++step) {
    const StepReport x = a.step(), y = b.step();
    ASSERT_EQ(x.iterations, y.iterations) << "step " << step;
    ASSERT_EQ(x.residual, y.residual) << "step " << step;
    ASSERT_EQ(x.converged, y.converged);
    sweeps += x.iterations;
    changes += x.iterations == last ? 0 : 1;
    last = x.iterations;
  }
  EXPECT_TRUE(same_bits(a.snapshot(), b.snapshot()));
  EXPECT_GT(changes, uint64_t{steps / 4}) << "the number of sweeps hardly changed: this shows little";
  EXPECT_LT(static_cast<uint64_t>(seldom.downloads[Field::sweeps]) * 4, sweeps)
      << "it is looked at too often";
}

TEST(Transfers, ACapEndsTheSolveWhereverItIsLookedAt) {
  for (const int cap : {1, 2, 3, 7}) {
    const Scene scene =
        shipped("breaking_dam", {"pressure.iisph.tolerance=1e-9", "pressure.iisph.min_iterations=1",
                                 "pressure.iisph.max_iterations=" + std::to_string(cap)});
    const Samples samples = sample(scene);
    const gpu::Context context;
    const auto gpu = gpu::make_backend(context);
    Simulator simulator(scene, samples, *gpu);
    for (int step = 0; step < 3; ++step) {
      const StepReport report = simulator.step();
      EXPECT_EQ(report.iterations, static_cast<uint32_t>(cap));
      EXPECT_FALSE(report.converged);
    }
  }
}

}  // namespace
}  // namespace sluice::test
