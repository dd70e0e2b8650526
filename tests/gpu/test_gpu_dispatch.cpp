// How work is spread over groups changes nothing: group sizes, one or two dispatch dimensions, sweeps
// enqueued together, and reductions of any length.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/model/larger.hpp"
#include "core/scene/random.hpp"
#include "core/solver/simulator.hpp"
#include "cpu/backend.hpp"
#include "cpu/fold.hpp"
#include "gpu/backend.hpp"
#include "gpu/compute_program.hpp"
#include "gpu/context.hpp"
#include "gpu/stage_program.hpp"
#include "sluice/error.hpp"
#include "sluice/sampling.hpp"
#include "tests/support/gpu.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

TEST(Spread, CoversAllGroupsWithinTheLimit) {
  for (const uint32_t most : {1u, 2u, 3u, 64u, 65'535u}) {
    const uint64_t square = uint64_t{most} * most;
    for (const uint64_t groups :
         {uint64_t{0}, uint64_t{1}, uint64_t{most} - 1, uint64_t{most}, uint64_t{most} + 1,
          2 * uint64_t{most} + 1, square - most, square - 1, square}) {
      if (groups > square) continue;
      const auto [x, y] = gpu::spread(groups, most);
      EXPECT_LE(x, most) << groups;
      EXPECT_LE(y, most) << groups;
      EXPECT_GE(uint64_t{x} * y, groups);
      EXPECT_LT(uint64_t{x} * y, groups + y) << "more than a column too many of " << groups;
      EXPECT_EQ(y > 1, groups > most) << groups;
    }
  }
}

/// More than 64 chunks, with walls and viscosity.
Scene scene_of_many_chunks(const std::string& method) {
  return shipped("breaking_dam",
                 {"particles.spacing=3", "viscosity.coefficient=50", "fluid.jitter=0.05", "fluid.relax=1",
                  "time.dt=0.01", "pressure.method=" + method, "pressure.iisph.max_iterations=20"});
}

/// Everything that a run of a few steps says, and its last state.
struct Outcome {
  std::vector<double> said;
  Snapshot snapshot;
  bool operator==(const Outcome& other) const {
    return said == other.said && same_bits(snapshot, other.snapshot);
  }
};

Outcome outcome(const Scene& scene, const gpu::BackendOptions& options) {
  const Samples samples = sample(scene);
  EXPECT_GT(samples.fluid.size(), chunk_width * chunk_width);
  const Gpu gpu(options);
  Simulator simulator(scene, samples, *gpu.backend);
  Outcome result;
  for (int step = 0; step < 3; ++step) {
    const StepReport report = simulator.step();
    std::array<double, total_count> totals{};
    gpu.backend->download(Field::totals, totals);
    result.said.insert(result.said.end(), totals.begin(), totals.end());
    result.said.push_back(report.iterations);
    result.said.push_back(report.residual);
    EXPECT_GT(report.diagnostics.kinetic_energy, 0);
  }
  result.snapshot = simulator.snapshot();
  return result;
}

class GpuDispatch : public testing::TestWithParam<std::string> {};

TEST_P(GpuDispatch, GroupSizesAndDimensionsChangeNoBit) {
  const Scene scene = scene_of_many_chunks(GetParam());
  const Outcome one = outcome(scene, {.group_size = 64});
  EXPECT_EQ(outcome(scene, {.group_size = 64}), one) << "a second run";
  EXPECT_EQ(outcome(scene, {.group_size = 128}), one);
  EXPECT_EQ(outcome(scene, {.group_size = 256}), one);
  EXPECT_EQ(outcome(scene, {.group_size = 64, .most_groups = 5}), one) << "two dimensions";
  EXPECT_EQ(outcome(scene, {.group_size = 64, .most_texels = 1}), one) << "no images";
  EXPECT_FALSE(outcome(scene_of_many_chunks(GetParam() == "ssph" ? "iisph" : "ssph"), {}) == one);
}

INSTANTIATE_TEST_SUITE_P(Methods, GpuDispatch, testing::Values("iisph", "ssph"));

TEST(GpuSweep, SweepsEnqueuedTogetherEndWhereThoseOneByOneDo) {
  const Scene scene = shipped("breaking_dam");
  const Samples samples = sample(scene);
  const Plan plan = make_plan(model_of(scene));
  std::vector<std::vector<double>> pressures;
  std::vector<uint32_t> counts;
  for (const bool together : {true, false}) {
    const Gpu gpu;
    Simulator simulator(scene, samples, *gpu.backend);
    simulator.step();
    // Once more from the pressure that the step ended with.
    gpu.backend->upload(Field::sweeps, std::array<uint32_t, 2>{});
    if (together)
      gpu.backend->sweep(plan[Phase::sweep], 200);
    else
      gpu.backend->Backend::sweep(plan[Phase::sweep], 200);
    std::array<uint32_t, 2> sweeps{};
    gpu.backend->download(Field::sweeps, sweeps);
    EXPECT_EQ(static_cast<Solve>(sweeps[1]), Solve::converged);
    counts.push_back(sweeps[0]);
    pressures.emplace_back(samples.fluid.size());
    gpu.backend->download(Field::q, pressures.back());
  }
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_GT(counts[0], 1u);
  EXPECT_LT(counts[0], 200u);
  EXPECT_EQ(pressures[0], pressures[1]);
}

/// Numbers of chunks on either side of where a fold gets another level, and one with more than three.
constexpr std::array<uint64_t, 10> chunk_counts{1, 2, 63, 64, 65, 4095, 4096, 4097, 5000, 262'145};

std::vector<float> random_values(uint64_t count, uint64_t seed) {
  std::vector<float> values(count);
  Random random(seed);
  for (float& value : values) value = static_cast<float>(random.uniform());
  return values;
}

std::vector<double> in_double(const std::vector<float>& values) { return {values.begin(), values.end()}; }

/// Equal, or both NaN; or so many units in the last place apart.
void expect_same(double found, float expected, uint64_t chunks, uint32_t which, double tolerance = 0) {
  const auto wanted = static_cast<double>(expected);
  const double apart = std::abs(found - wanted);
  EXPECT_TRUE(found == wanted || (std::isnan(found) && std::isnan(wanted)) ||
              apart <= tolerance * 0x1p-23 * std::abs(wanted))
      << found << " for " << wanted << ", number " << which << " of " << chunks << " chunks";
}

// Invocations run in any order, so no level may write where it reads.
TEST(GpuFold, EveryLevelWritesElsewhereThanItReadsAndWithinItsMemory) {
  for (const uint64_t chunks : chunk_counts) {
    const Sizes sizes{.fluid = chunks * chunk_width};
    const uint64_t scratch = gpu::scratch_size(sizes);
    for (const auto& [stage, arrays] :
         {std::pair(Stage::stop_test, residual_sum_count), std::pair(Stage::totals, total_count)}) {
      uint64_t length = chunks, written = 0;
      for (const gpu::Pass& pass : gpu::passes_of(stage, sizes, 64)) {
        EXPECT_EQ(pass.fold_length, length);
        EXPECT_EQ(pass.fold_first, length == chunks);
        if (!pass.fold_first) {
          EXPECT_EQ(pass.fold_from, written);
        }
        if (pass.number != 0) break;
        const uint64_t groups = (length + chunk_width - 1) / chunk_width;
        EXPECT_EQ(pass.count, arrays * groups);
        EXPECT_LE(pass.fold_to + arrays * groups, scratch);
        if (!pass.fold_first) {
          EXPECT_TRUE(pass.fold_to + arrays * groups <= pass.fold_from ||
                      pass.fold_from + arrays * length <= pass.fold_to)
              << chunks;
        }
        written = pass.fold_to;
        length = groups;
      }
      EXPECT_LE(length, chunk_width);
    }
  }
}

TEST(GpuFold, TotalsAreThoseOfTheTreeOfSixtyFours) {
  Gpu gpu;
  for (const uint64_t chunks : chunk_counts) {
    std::vector<float> values = random_values(total_count * chunks, chunks);
    for (const Total total : {Total::y, Total::max_speed_squared})  // NaN stays, wherever it stands
      values[static_cast<uint32_t>(total) * chunks + chunks * 2 / 3] =
          std::numeric_limits<float>::quiet_NaN();
    gpu.allocate({Field::diagnostic_sums, Field::totals}, {.fluid = chunks * chunk_width - 5});
    gpu.backend->upload(Field::diagnostic_sums, in_double(values));
    gpu.backend->run(Stage::totals);
    const auto found = gpu.reals(Field::totals);
    for (uint32_t total = 0; total < total_count; ++total) {
      const float* first = values.data() + total * chunks;
      const float expected = total < first_max_total ? cpu::fold(first, chunks, std::plus<float>())
                                                     : cpu::fold(first, chunks, larger<float>);
      expect_same(found[total], expected, chunks, total);
    }
  }
}

/// What the stop test says, sums in, on any backend.
std::pair<std::vector<double>, std::vector<uint32_t>> stop_test_of(Backend& backend, uint64_t chunks,
                                                                   const std::vector<float>& sums,
                                                                   uint32_t sweeps_before, double smallest) {
  backend.allocate({Field::residual_sums, Field::solve, Field::sweeps}, {.fluid = chunks * chunk_width - 5});
  backend.upload(Field::residual_sums, in_double(sums));
  backend.upload(Field::solve, std::array<double, 4>{0.5, smallest, 0.5, 1});
  backend.upload(Field::sweeps, std::array<uint32_t, 2>{sweeps_before, 0});
  backend.run(Stage::stop_test);
  std::vector<double> solve(4);
  std::vector<uint32_t> sweeps(2);
  backend.download(Field::solve, solve);
  backend.download(Field::sweeps, sweeps);
  return {solve, sweeps};
}

TEST(GpuFold, TheStopTestIsTheCpus) {
  Gpu gpu;
  const auto cpu = cpu::make_backend(Precision::single_, 1);
  std::set<std::pair<uint32_t, double>> outcomes;
  for (const char* stop : {"density", "residual"}) {
    for (const char* solver : {"jacobi", "barzilai-borwein"}) {
      const Scene scene = shipped(
          "breaking_dam", {std::string("pressure.iisph.stop=") + stop,
                           std::string("pressure.iisph.solver=") + solver, "pressure.iisph.tolerance=1.02"});
      gpu.backend->configure(make_params(scene, 1), needs_of(scene));
      cpu->configure(make_params(scene, 1), needs_of(scene));
      for (const uint64_t chunks : chunk_counts) {
        const std::vector<float> sums = random_values(residual_sum_count * chunks, chunks);
        for (const auto& [before, smallest] :
             {std::pair{0u, 0.25}, {1u, 0.25}, {2u, 0.25}, {999u, 0.25}, {999u, 1e30}}) {
          const auto expected = stop_test_of(*cpu, chunks, sums, before, smallest);
          const auto found = stop_test_of(*gpu.backend, chunks, sums, before, smallest);
          // A quotient and its root; graphics cards need not round them correctly.
          const double tolerance = gpu.context.software() ? 0 : 4;
          for (size_t k = 0; k < 4; ++k)
            expect_same(found.first[k], static_cast<float>(expected.first[k]), chunks, before, tolerance);
          EXPECT_EQ(found.second, expected.second) << chunks << " chunks, " << before << " sweeps before";
          outcomes.insert({expected.second[1], expected.first[3]});
        }
      }
    }
  }
  EXPECT_EQ(outcomes.size(), 4u) << "unfinished, converged, capped with an update and going back";
}

TEST(GpuBackend, DeletesItsOwnObjectsWhicheverContextIsCurrent) {
  const gpu::Context first, second;
  auto doomed = gpu::make_backend(first);
  const auto kept = gpu::make_backend(second);
  const Sizes sizes{100, 0, 10, 2000};
  doomed->allocate({Field::rho, Field::p}, sizes);
  kept->allocate({Field::rho, Field::p}, sizes);
  const std::vector<double> values(100, 7.0);
  kept->upload(Field::rho, values);  // the second context is current now
  doomed.reset();
  std::vector<double> found(100);
  kept->download(Field::rho, found);
  EXPECT_EQ(found, values);
}

TEST(GpuBackend, RefusesAGridThatItCannotSortInto) {
  const gpu::Context context;
  const auto backend = gpu::make_backend(context, {.group_size = 64});
  try {
    backend->allocate({}, {100, 0, 140'000'000, 2000});
    FAIL() << "nothing was said";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("a grid of 140000000 cells"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sluice::test
