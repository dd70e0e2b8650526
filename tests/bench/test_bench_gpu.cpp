// What is timed on the GPU is what the page says: the stages of a step, sweeps that compute what the
// yardstick computes, and the bytes that a sweep moves. What could not be measured is said to be missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/gpu_page.hpp"
#include "gpu/context.hpp"

namespace sluice::test {
namespace {

constexpr uint32_t small = 1000;

TEST(BenchGpu, EveryStageOfTheStepHasATime) {
  const gpu::Context context;
  bench::Case subject({PressureMethod::iisph, small, Precision::single_, 1, bench::Machine::gpu}, &context);
  const bench::StepTimes times = bench::time_steps(subject);
  EXPECT_EQ(times.n, subject.n());
  EXPECT_GT(times.in_stages, 0);
  const std::vector<Stage> planned = subject.plan().stages();  // of which none runs once
  for (uint32_t i = 0; i < stage_count; ++i) {
    const Stage stage = static_cast<Stage>(i);
    const bool runs = std::find(planned.begin(), planned.end(), stage) != planned.end();
    EXPECT_EQ(runs, !std::isnan(times.stage[i])) << info(stage).name;
  }
}

TEST(BenchGpu, EveryStageIsTimedWithAMethodThatHasIt) {
  for (uint32_t i = 0; i < stage_count; ++i) {
    const Stage stage = static_cast<Stage>(i);
    if (stage == Stage::relax) continue;
    const Plan plan = make_plan(model_of(bench::make_scene({bench::timed_with(stage), small})));
    const std::vector<Stage> planned = plan.stages();
    EXPECT_NE(std::find(planned.begin(), planned.end(), stage), planned.end()) << info(stage).name;
  }
}

TEST(BenchGpu, EveryRepetitionIsTheSameSteps) {
  const gpu::Context context;
  const bench::CaseKey key{PressureMethod::iisph, small, Precision::single_, 1, bench::Machine::gpu};
  bench::Case timed(key, &context), stepped(key, &context);
  bench::time_steps(timed);
  for (int step = 0; step < 10; ++step) stepped.step();
  std::vector<double> x(2 * timed.n()), expected(x.size());
  timed.backend().download(Field::x_in, x);
  stepped.backend().download(Field::x_in, expected);
  EXPECT_EQ(x, expected);
}

/// compare_sweeps() throws when they differ.
TEST(BenchGpu, SweepsAreComparedWithTheYardsticks) {
  const gpu::Context context;
  EXPECT_NO_THROW(bench::compare_sweeps(small, context));
}

TEST(BenchGpu, SweepBytesAreThoseOfTheStageTable) {
  const Plan plan = make_plan({.boundary = BoundaryModel::mirror,
                               .method = PressureMethod::iisph,
                               .wall = Wall::symmetric,
                               .solver = Solver::barzilai_borwein});
  constexpr uint64_t n = 6400, entries = 70'000;
  // Per entry in both passes: index and gradient. Per particle:
  constexpr double acceleration = 8 + 4 + 4 + 8 + 8;  // list, q, rho, wall_gradient; a_p
  constexpr double change = 8 + 8 + 8 + 4;            // list, a_p, wall_gradient; Ap
  constexpr double residual = 6 * 4;                  // Ap, s, A_ii, q, q_before, Ap_before
  constexpr double update = 5 * 4 + 4 * 4;   // Ap, s, A_ii, q, q_best; q, q_best, q_before, Ap_before
  constexpr double sums = 7 * 2 * 4 / 64.0;  // seven sums per chunk, written and read
  constexpr double of_all = 2 * 8 + 3 * 16;  // sweeps and solve, read and written; solve once more
  EXPECT_DOUBLE_EQ(bench::sweep_bytes(plan, n, entries),
                   2 * (4 + 8) * entries + n * (acceleration + change + residual + update + sums) + of_all);
}

TEST(BenchGpu, TheSwitchIsWhereTheGpuIsFasterFromThereOn) {
  EXPECT_EQ(bench::faster_from({}), std::nullopt);
  EXPECT_EQ(bench::faster_from({{10, 1, 2}, {20, 1, 1}}), std::nullopt);
  EXPECT_EQ(bench::faster_from({{10, 3, 2}, {20, 1, 2}, {40, 3, 2}, {80, 4, 2}}), 40u)
      << "10 was an accident";
  const gpu::Context context;
  const bench::StepPair pair = bench::compare_steps(small, context);
  EXPECT_GT(pair.n, 0u);
  EXPECT_GT(pair.cpu, 0);
  EXPECT_GT(pair.gpu, 0);
}

TEST(BenchGpu, PagesAreNamedAfterTheGpu) {
  EXPECT_EQ(bench::page_name("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe.md");
  EXPECT_EQ(bench::page_name("NVIDIA H100 80GB HBM3/PCIe/SSE2"), "nvidia-h100-80gb-hbm3.md");
  EXPECT_EQ(bench::page_name("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), "mesa-intel-r-uhd-graphics-620.md");
  EXPECT_EQ(bench::page_name("Intel(R)"), "intel-r.md");
  EXPECT_EQ(bench::page_name("../"), "unknown.md");
}

TEST(BenchGpu, PageSaysWhichSizeWasLeftOutAndWhy) {
  bench::GpuReport report;
  report.others = 0.5;
  const bench::StepTimes measured;
  std::map<PressureMethod, bench::StepTimes> steps;
  for (const PressureMethod method : bench::methods) steps[method] = measured;
  report.cpu = {100'000, steps, ""};
  report.sizes = {{10'000, steps, ""}, {10'000'000, {}, "graphics memory is full"}};
  const std::string page = bench::gpu_page(report);
  EXPECT_NE(page.find("| fluid particles | 0 | left out |"), std::string::npos);
  EXPECT_NE(page.find("10M left out: graphics memory is full"), std::string::npos);
  EXPECT_NE(page.find("meanwhile: 0.50 processors; **the machine was busy"), std::string::npos);
}

}  // namespace
}  // namespace sluice::test
