// A step whose neighbour list came out too short is done again with a longer one, and nothing of the first
// attempt remains: not in the state, not on either backend, not in a run that is split between them.
#include <gtest/gtest.h>

#include "core/agree/agree.hpp"
#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "tests/support/growing.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// Has a list that is long enough from the beginning, and says so.
class LongList final : public ForwardingBackend {
 public:
  explicit LongList(Backend& backend) : ForwardingBackend(backend) {}
  void allocate(FieldSet fields, const Sizes& sizes) override {
    Sizes larger = sizes;
    larger.list *= 8;
    ForwardingBackend::allocate(fields, larger);
  }
  void download(Field field, std::span<uint32_t> values) const override {
    ForwardingBackend::download(field, values);
    if (field != Field::list_needed) return;
    EXPECT_LE(values[0], 8 * first_list_size(660, 1)) << "even this list is too short";
    values[0] = 0;
  }
};

/// A fluid so soft that it is crushed, and its lists outgrow the room set aside for them.
Scene crushed(const std::string& method) {
  std::vector<std::string> overrides = {"pressure.method=" + method, "pressure.ssph.stiffness=300"};
  if (method == "iisph")
    overrides.insert(overrides.end(), {"pressure.iisph.max_iterations=1", "pressure.iisph.min_iterations=1",
                                       "pressure.iisph.omega=0.001"});
  return shipped("breaking_dam", overrides);
}

Snapshot state_after(const Scene& scene, Backend& backend, int steps) {
  const Samples samples = sample(scene);
  Simulator simulator(scene, samples, backend);
  for (int step = 0; step < steps && !simulator.failure(); ++step) simulator.step();
  EXPECT_EQ(simulator.steps(), static_cast<uint64_t>(steps));
  return simulator.snapshot();
}

class ListGrowth : public testing::TestWithParam<std::string> {};

TEST_P(ListGrowth, LeavesNoTrace) {
  const Scene scene = crushed(GetParam());
  const int steps = GetParam() == "ssph" ? 450 : 150;
  const gpu::Context context;
  const auto cpu = cpu::make_backend(Precision::single_, 2), roomy = cpu::make_backend(Precision::single_, 2);
  const auto gpu = gpu::make_backend(context);
  Growing on_cpu(*cpu), on_gpu(*gpu);
  LongList ready(*roomy);
  const Snapshot expected = state_after(scene, ready, steps);
  EXPECT_TRUE(same_bits(state_after(scene, on_cpu, steps), expected));
  EXPECT_GT(on_cpu.times, 0) << "the CPU's list never grew";
  const Snapshot found = state_after(scene, on_gpu, steps);
  EXPECT_GT(on_gpu.times, 0) << "the GPU's list never grew";
  if (context.software()) {
    EXPECT_TRUE(same_bits(found, expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, ListGrowth, testing::Values("ssph", "iisph"),
                         [](const auto& row) { return row.param; });

/// Counts what belongs to the other half of a split step.
class SecondHalf final : public ForwardingBackend {
 public:
  explicit SecondHalf(Backend& backend) : ForwardingBackend(backend) {}
  void run(Stage stage) override {
    if (stage == Stage::density) ++densities;
    ForwardingBackend::run(stage);
  }
  int densities = 0;
};

TEST(ListGrowth, KeepsASplitStepSplit) {
  const Scene scene = crushed("ssph");
  const auto first = cpu::make_backend(Precision::single_, 2),
             second = cpu::make_backend(Precision::single_, 2);
  SecondHalf watched(*second);
  SplitBackend halves(*first, watched, Stage::density);
  Growing growing(halves);
  state_after(scene, growing, 450);
  EXPECT_GT(growing.times, 0);
  EXPECT_EQ(watched.densities, 0) << "the second half ran what belongs to the first";
}

}  // namespace
}  // namespace sluice::test
