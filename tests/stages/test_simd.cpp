// Every stage of every scene, with each set of instructions against the plain ones: from identical input, and
// over whole runs, in float and in double, to the last bit. What cpu/simd has is found, so that a stage that
// gets a file there is tested with no word here.
#include <gtest/gtest.h>

#include <set>

#include "core/agree/agree.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

/// Expects that all stages of the scene's plan and its run agree.
void expect_equal(const Scene& scene, Precision precision, cpu::Instructions instructions, int threads,
                  uint64_t steps) {
  const auto plain = cpu::make_backend(precision, 2, cpu::Instructions::plain);
  const auto stages = cpu::make_backend(precision, threads, instructions);
  const auto run = cpu::make_backend(precision, threads, instructions);
  const Agreement found = agree(scene, sample(scene), {*plain, *stages, *run}, steps, 0);
  std::set<Stage> compared;
  for (const StageAgreement& row : found.stages) {
    compared.insert(row.stage);
    EXPECT_TRUE(row.difference.agrees(0))
        << info(row.stage).name << ": " << row.difference.equal << " of " << row.difference.values
        << " equal, first difference in "
        << (row.difference.first ? info(row.difference.first->field).name : "nothing");
  }
  const std::vector<Stage> planned = make_plan(model_of(scene)).stages();
  EXPECT_EQ(compared, std::set<Stage>(planned.begin(), planned.end()));
  EXPECT_EQ(found.run.steps, steps);
  EXPECT_TRUE(found.pass) << "the run differs from step " << found.run.first_difference_step << " on";
}

std::vector<cpu::Instructions> wide_instructions() {
  std::vector<cpu::Instructions> wide = cpu::available_instructions();
  std::erase(wide, cpu::Instructions::plain);
  EXPECT_FALSE(wide.empty()) << "nothing to compare: this build has plain stages only";
  return wide;
}

/// Whether all that is available agrees: in float on `threads`, in double on one, which leaves lists
/// elsewhere.
void expect_all_equal(const Scene& scene, int threads = 2, uint64_t steps = 40) {
  for (const cpu::Instructions instructions : wide_instructions()) {
    SCOPED_TRACE(std::string(name_of(instructions)) + ", threads " + std::to_string(threads));
    expect_equal(scene, Precision::single_, instructions, threads, steps);
    expect_equal(scene, Precision::double_, instructions, 1, steps);
  }
}

class Simd : public testing::TestWithParam<ShippedRun> {};

TEST_P(Simd, StagesAndRunsHaveTheBitsOfThePlainOnes) {
  // A jittered start, so that no comparison rests on the symmetry of a lattice.
  expect_all_equal(GetParam().load({"fluid.jitter=0.05"}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Simd, testing::ValuesIn(shipped_runs()),
                         [](const auto& test) { return test.param.name(); });

// What no shipped scene plans, no generated test of agreement runs.
TEST(Simd, EveryStageIsPlannedByAShippedScene) {
  std::set<Stage> planned;
  for (const ShippedRun& run : shipped_runs())
    for (const Stage stage : make_plan(model_of(run.load())).stages()) planned.insert(stage);
  for (const Stage stage : make_plan(model_of(shipped("breaking_dam")), Task::relaxation).stages())
    planned.insert(stage);
  for (uint32_t i = 0; i < stage_count; ++i)
    EXPECT_TRUE(planned.contains(static_cast<Stage>(i)))
        << stage_table()[i].name << ": let scenes/template.toml ask for it";
}

struct Variant {
  ShippedRun run;
  std::vector<std::string> overrides;
};

// Models in other company than in the shipped scenes.
TEST(SimdVariants, HaveTheBitsOfThePlainOnes) {
  const std::string laplacian = "viscosity={model=\"laplacian\",coefficient=0.1}";
  const std::string xsph = "viscosity={model=\"xsph\",coefficient=0.05}", akinci = "boundary.model=akinci";
  const std::string relax = "fluid.relax=5", scattered = "fluid.jitter=0.3";
  const std::vector<std::string> exact = {"pressure.iisph.solver=barzilai-borwein",
                                          "pressure.iisph.wall=symmetric", "pressure.iisph.stop=residual"};
  const auto with = [](std::vector<std::string> words, const std::string& more) {
    words.push_back(more);
    return words;
  };
  for (const Variant& variant : {Variant{{"wcsph_box", "wcsph"}, {laplacian}},
                                 {{"wcsph_box", "wcsph"}, {"pressure.wcsph.gamma=6.3"}},
                                 {{"iisph_box", "iisph"}, {laplacian}},
                                 {{"breaking_dam", "iisph"}, {xsph, akinci}},
                                 {{"breaking_dam", "iisph"}, exact},
                                 {{"breaking_dam", "iisph"}, with(exact, relax)},
                                 {{"breaking_dam", "ssph"}, {akinci}},
                                 {{"breaking_dam", "iisph"}, {scattered, "viscosity.coefficient=20"}},
                                 {{"breaking_dam", "wcsph"}, {xsph}}}) {
    SCOPED_TRACE(variant.run.name() + ": " + testing::PrintToString(variant.overrides));
    expect_all_equal(variant.run.load(variant.overrides));
  }
}

TEST(SimdVariants, RelaxWithTheBitsOfThePlainOnes) {
  const Scene scene = shipped("breaking_dam", {"fluid.jitter=0.2", "fluid.relax=3"});
  const Samples samples = sample(scene);
  for (const cpu::Instructions instructions : wide_instructions()) {
    const auto plain = cpu::make_backend(Precision::double_, 2, cpu::Instructions::plain);
    const auto other = cpu::make_backend(Precision::double_, 2, instructions);
    ComparingBackend comparing(*plain, *other);
    comparing.compare_from_now_on(true);
    const Simulator simulator(scene, samples, comparing);
    for (const Stage stage : make_plan(model_of(scene), Task::relaxation).stages())
      EXPECT_TRUE(comparing.difference(stage).values > 0 && comparing.difference(stage).within(0))
          << name_of(instructions) << ", " << info(stage).name;
    for (const Stage stage : {Stage::relax, Stage::pressure_update})
      EXPECT_TRUE(comparing.difference(stage).agrees(0)) << name_of(instructions) << ", " << info(stage).name;
  }
}

// Enough particles for blocks of a sweep that follow each other, and for every thread.
TEST(SimdVariants, OfManyParticlesHaveTheBitsOfThePlainOnes) {
  const Scene scene = shipped("breaking_dam", {"particles.spacing=2.5", "viscosity.coefficient=50",
                                               "time.dt=0.003", "fluid.jitter=0.05"});
  for (const int threads : {2, 4}) expect_all_equal(scene, threads, 4);
}

}  // namespace
}  // namespace sluice::test
